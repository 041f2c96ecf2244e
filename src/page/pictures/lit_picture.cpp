#include "page/pictures/lit_picture.h"

#include "core/environment.h"
#include "core/srgb.h"
#include "page/document/base64.h"
#include "page/pictures/coloured_picture.h"
#include "page/pictures/stored_images.h"
#include "page/pictures/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace aoscore {
namespace {

constexpr int kLitErrorShades = 63;

std::uint8_t lit_shade(float value, double white) {
    const double share = std::clamp(double{value} / white, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(share)));
}

float largest_at(const ColourPlanes& colours, std::size_t i) {
    return std::max({colours[0].pixels[i], colours[1].pixels[i], colours[2].pixels[i]});
}

}  // namespace

ColourPlanes colour_planes(const ImageFile& file, const std::filesystem::path& path,
                           const std::array<std::string, 3>& channels) {
    return {channel_of(file, path, channels[0]), channel_of(file, path, channels[1]),
            channel_of(file, path, channels[2])};
}

ImageF luminance_of(const ColourPlanes& colours) {
    ImageF result(colours[0].width, colours[0].height);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result.pixels[i] =
            static_cast<float>(luminance({colours[0].pixels[i], colours[1].pixels[i], colours[2].pixels[i]}));
    }
    return result;
}

ImageF largest_of(const ColourPlanes& colours) {
    ImageF result(colours[0].width, colours[0].height);
    for (std::size_t i = 0; i < result.size(); ++i) result.pixels[i] = largest_at(colours, i);
    return result;
}

Picture lit_picture(const ColourPlanes& colours, double white, int width_px) {
    const ColourPlanes small{shrunk(colours[0], width_px), shrunk(colours[1], width_px),
                             shrunk(colours[2], width_px)};
    Image<std::array<std::uint8_t, 3>> shades(small[0].width, small[0].height);
    for (std::size_t i = 0; i < shades.size(); ++i) {
        const double full = std::max(white, double{largest_at(small, i)});
        for (std::size_t c = 0; c < 3; ++c) shades.pixels[i][c] = lit_shade(small[c].pixels[i], full);
    }
    return {"data:image/png;base64," + base64(encode_png_rgb(shades)), shades.width, shades.height};
}

Picture lit_error_picture(const ColourPlanes& colours, const ImageF& truth, double mean, const Mask& valid,
                          int width_px) {
    ImageF error = luminance_of(colours);
    for (std::size_t i = 0; i < error.size(); ++i) {
        error.pixels[i] = valid.pixels[i] != 0
                              ? static_cast<float>((double{error.pixels[i]} - double{truth.pixels[i]}) / mean)
                              : std::numeric_limits<float>::quiet_NaN();
    }
    error = shrunk(error, width_px);
    Palette palette = blue_red_palette(kLitErrorShades);
    palette.back() = kNotComparedColour;
    return {coloured_picture({&error}, -kLitErrorRange, kLitErrorRange, palette), error.width, error.height};
}

}  // namespace aoscore
