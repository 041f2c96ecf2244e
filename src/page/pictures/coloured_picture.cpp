#include "page/pictures/coloured_picture.h"

#include "image/image_file.h"
#include "page/document/base64.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr std::uint32_t kNoNumberColour = 0xff00ff;

}  // namespace

Palette palette_between(const std::vector<std::array<double, 3>>& anchors, int steps) {
    Palette palette;
    for (int i = 0; i < steps; ++i) {
        const double place = static_cast<double>(i) / (steps - 1) * static_cast<double>(anchors.size() - 1);
        const std::size_t low = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
        std::uint32_t colour = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double value =
                std::lerp(anchors[low][channel], anchors[low + 1][channel], place - static_cast<double>(low));
            colour = colour << 8U | static_cast<std::uint32_t>(std::lround(value));
        }
        palette.push_back(colour);
    }
    palette.push_back(kNoNumberColour);
    return palette;
}

Palette gray_palette(int steps) {
    return palette_between({{0, 0, 0}, {255, 255, 255}}, steps);
}

Palette blue_red_palette(int steps) {
    return palette_between({{5, 48, 97}, {67, 147, 195}, {247, 247, 247}, {214, 96, 77}, {103, 0, 31}},
                           steps);
}

Palette magma_palette(int steps) {
    return palette_between({{0, 0, 4},
                            {29, 17, 71},
                            {81, 18, 124},
                            {131, 38, 129},
                            {183, 55, 121},
                            {231, 82, 99},
                            {252, 137, 97},
                            {254, 196, 136},
                            {252, 253, 191}},
                           steps);
}

std::string coloured_picture(const std::vector<const ImageF*>& images, double low, double high,
                             const Palette& palette) {
    const int width = images.front()->width, height = images.front()->height;
    const double last = static_cast<double>(palette.size() - 2);
    Image<std::uint8_t> codes(width, height * static_cast<int>(images.size()));
    std::size_t at = 0;
    for (const ImageF* image : images) {
        for (const float value : image->pixels) {
            const double place = (static_cast<double>(value) - low) / (high - low) * last;
            codes.pixels[at++] = std::isfinite(value)
                                     ? static_cast<std::uint8_t>(std::lround(std::clamp(place, 0.0, last)))
                                     : static_cast<std::uint8_t>(palette.size() - 1);
        }
    }
    return "data:image/png;base64," + base64(encode_png_indexed(codes, palette));
}

}  // namespace aoscore
