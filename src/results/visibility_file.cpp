#include "results/visibility_file.h"

#include "core/error.h"
#include "results/image_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

namespace aoscore {
namespace {

/// The last part of a channel's name, or of its layer's: "ViewLayer.AO.R" is channel R of the layer "AO".
struct ChannelName {
    std::string layer, component;

    explicit ChannelName(const std::string& name) {
        const auto dot = name.rfind('.');
        component = name.substr(dot == std::string::npos ? 0 : dot + 1);
        if (dot == std::string::npos) return;
        const auto before = name.rfind('.', dot - 1);
        const std::size_t begin = dot == 0 || before == std::string::npos ? 0 : before + 1;
        layer = name.substr(begin, dot - begin);
    }
};

/// Channels that go with a picture and are none: alpha, depth (Z of Blender and this program), and layers of
/// pbrt's GBufferFilm (P, N, Ns, Albedo, Variance, …), Blender's passes and Mitsuba's aov integrator.
bool is_companion(const std::string& name) {
    static const std::set<std::string, std::less<>> kComponents = {"A", "Z", "u", "v", "alpha"};
    static const std::set<std::string, std::less<>> kLayers = {
        "mask",   "SE",       "depth",     "Depth",     "Normal", "N",
        "Ns",     "P",        "Position",  "albedo",    "Albedo", "Variance",
        "Vector", "UV",       "IndexOB",   "IndexMA",   "Mist",   "RelativeVariance",
        "uv",     "position", "sh_normal", "geo_normal"};
    const ChannelName parts(name);
    return kComponents.contains(parts.component) || kLayers.contains(parts.layer);
}

bool is_ambient_occlusion(const std::string& name) {
    static const std::set<std::string, std::less<>> kNames = {"AO", "Ambient Occlusion", "ao",
                                                              "ambientocclusion", "ambient_occlusion"};
    const ChannelName parts(name);
    return kNames.contains(parts.component) ||
           (kNames.contains(parts.layer) && (parts.component == "R" || parts.component == "Y"));
}

bool same_values(const ImageF& a, const ImageF& b) {
    return std::ranges::equal(a.pixels, b.pixels,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Whether `red` is the R of three equal channels.
bool is_red_of_gray(const ImageFile& file, const std::string& red) {
    if (!(red == "R" || red.ends_with(".R"))) return false;
    const std::string stem = red.substr(0, red.size() - 1);
    const ImageF *g = file.channel(stem + "G"), *b = file.channel(stem + "B");
    const ImageF& r = *file.channel(red);
    return g != nullptr && b != nullptr && same_values(r, *g) && same_values(r, *b);
}

std::string found_channel(const ImageFile& file, const std::string& where) {
    if (file.channel("Y") != nullptr) return "Y";
    std::vector<std::string> own, occlusion, gray;
    for (const std::string& name : file.channel_names) {
        if (is_companion(name)) continue;
        own.push_back(name);
        if (is_ambient_occlusion(name)) occlusion.push_back(name);
    }
    if (own.size() == 1) return own.front();
    if (file.channel("R") != nullptr && is_red_of_gray(file, "R")) return "R";
    if (occlusion.size() == 1) return occlusion.front();
    for (const std::string& name : own) {
        if (occlusion.empty() && is_red_of_gray(file, name)) gray.push_back(name);
    }
    if (gray.size() == 1) return gray.front();
    throw file_error(
        fmt::format("{} channel of visibility among {}",
                    occlusion.empty() && gray.empty() ? "no" : "more than one",
                    fmt::join(file.channel_names, ", ")),
        where, "Y, a single channel, R = G = B, or one <layer>.AO.R; or the channel's name, by --channel");
}

std::string channel_to_read(const ImageFile& file, const std::string& asked, const std::string& where) {
    if (asked.empty()) return found_channel(file, where);
    if (file.channel(asked) != nullptr) return asked;
    throw file_error("has no channel " + asked, where,
                     fmt::format("{}", fmt::join(file.channel_names, ", ")));
}

float linear_from_srgb(float coded) {
    return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F);
}

template <class T>
void turn_over(Image<T>& image) {
    for (int y = 0; y < image.height / 2; ++y) {
        std::swap_ranges(&image.at(0, y), &image.at(0, y) + image.width, &image.at(0, image.height - 1 - y));
    }
}

Mask above_half(const ImageF& image) {
    Mask mask(image.width, image.height);
    std::ranges::transform(image.pixels, mask.pixels.begin(),
                           [](float value) { return static_cast<std::uint8_t>(value > 0.5F ? 1 : 0); });
    return mask;
}

}  // namespace

VisibilityFile read_visibility(const std::filesystem::path& path, const VisibilityReading& reading) {
    const ImageFile file = read_image(path);
    VisibilityFile result;
    result.channel = channel_to_read(file, reading.channel, path.string());
    result.integers = file.integers;
    if (file.integers && !reading.coding) {
        throw usage_error("holds integers, which may be sRGB-coded or linear", path.string(),
                          "--srgb, as pictures for the screen are, or --linear");
    }
    result.visibility = *file.channel(result.channel);
    if (file.integers && reading.coding == Coding::srgb) {
        for (float& value : result.visibility.pixels) value = linear_from_srgb(value);
    }
    if (reading.invert) {
        for (float& value : result.visibility.pixels) value = 1 - value;
    }
    const ImageF* mask = file.channel("mask.Y");
    result.mask = mask != nullptr ? above_half(*mask) : Mask(file.width, file.height, 1);
    if (const ImageF* error = file.channel("SE.Y")) result.standard_error = *error;
    if (reading.flip) {
        turn_over(result.visibility);
        turn_over(result.mask);
        turn_over(result.standard_error);
    }
    return result;
}

Mask read_mask(const std::filesystem::path& path) {
    return above_half(read_image(path).channels.front());
}

}  // namespace aoscore
