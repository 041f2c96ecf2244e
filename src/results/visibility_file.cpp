#include "core/error.h"
#include "results/image_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// Channels that go with a visibility but are none.
bool is_companion(const std::string& name) {
    return name == "A" || name == "mask.Y" || name == "SE.Y";
}

/// Names by which other programs call an ambient-occlusion layer: Blender's is <view layer>.AO.R.
bool is_ambient_occlusion(const std::string& name) {
    return name == "AO" || name == "AO.R" || name == "AO.Y" || name.ends_with(".AO.R") ||
           name.ends_with(".AO.Y") || name.ends_with(".AO");
}

bool same_values(const ImageF& a, const ImageF& b) {
    return std::ranges::equal(a.pixels, b.pixels,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool is_gray(const ImageFile& file) {
    const ImageF *r = file.channel("R"), *g = file.channel("G"), *b = file.channel("B");
    return r != nullptr && g != nullptr && b != nullptr && same_values(*r, *g) && same_values(*r, *b);
}

std::string visibility_channel(const ImageFile& file, const std::string& where) {
    if (file.channel("Y") != nullptr) return "Y";
    std::vector<std::string> own, occlusion;
    for (const std::string& name : file.channel_names) {
        if (!is_companion(name)) own.push_back(name);
        if (is_ambient_occlusion(name)) occlusion.push_back(name);
    }
    if (own.size() == 1) return own.front();
    if (is_gray(file)) return "R";
    if (occlusion.size() == 1) return occlusion.front();
    throw file_error(
        fmt::format("{} channel of visibility among {}", occlusion.empty() ? "no" : "more than one",
                    fmt::join(file.channel_names, ", ")),
        where, "Y, a single channel, R = G = B, or one <layer>.AO.R");
}

float linear_from_srgb(float coded) {
    return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

VisibilityFile read_visibility(const std::filesystem::path& path, bool srgb) {
    const ImageFile file = read_image(path);
    VisibilityFile result;
    result.channel = visibility_channel(file, path.string());
    result.visibility = *file.channel(result.channel);
    if (srgb && file.eight_bit) {
        for (float& value : result.visibility.pixels) value = linear_from_srgb(value);
    }
    result.mask = Mask(file.width, file.height, 1);
    if (const ImageF* mask = file.channel("mask.Y")) {
        std::ranges::transform(mask->pixels, result.mask.pixels.begin(),
                               [](float value) { return static_cast<std::uint8_t>(value > 0.5F ? 1 : 0); });
    }
    if (const ImageF* error = file.channel("SE.Y")) result.standard_error = *error;
    return result;
}

}  // namespace aoscore
