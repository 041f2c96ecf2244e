#include "report/colour_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace aoscore {
namespace {

constexpr std::array<Rgb, 9> kMagma = {0x000004, 0x1d1147, 0x51127c, 0x832681, 0xb73779,
                                       0xe75263, 0xfc8961, 0xfec488, 0xfcfdbf};
constexpr std::array<Rgb, 9> kViridis = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                         0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
constexpr std::array<Rgb, 9> kBlueRed = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xf7f7f7,
                                         0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};
constexpr std::array<Rgb, 2> kGray = {0x000000, 0xffffff};

}  // namespace

ColourMap magma() {
    return kMagma;
}
ColourMap viridis() {
    return kViridis;
}
ColourMap blue_red() {
    return kBlueRed;
}
ColourMap gray() {
    return kGray;
}

Rgb colour_at(ColourMap map, double position) {
    assert(map.size() >= 2);
    const double place = std::clamp(position, 0.0, 1.0) * static_cast<double>(map.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(place), map.size() - 2);
    const double part = place - static_cast<double>(low);
    Rgb colour = 0;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const double a = map[low] >> shift & 255U, b = map[low + 1] >> shift & 255U;
        colour |= static_cast<Rgb>(std::lround(a + (b - a) * part)) << shift;
    }
    return colour;
}

std::vector<Rgb> palette(ColourMap map, int steps) {
    assert(steps >= 2);
    std::vector<Rgb> colours;
    for (int i = 0; i < steps; ++i) colours.push_back(colour_at(map, i / (steps - 1.0)));
    return colours;
}

std::string css_colour(Rgb colour) {
    return fmt::format("#{:06x}", colour);
}

std::string css_gradient(ColourMap map) {
    std::string text = "linear-gradient(to right";
    for (const Rgb colour : map) text += "," + css_colour(colour);
    return text + ")";
}

}  // namespace aoscore
