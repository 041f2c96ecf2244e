#include "report/picture_encoding.h"

#include "report/base64.h"
#include "report/colour_map.h"
#include "results/image_file.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

using Bytes = Image<std::uint8_t>;

// Steps of 0.025: about the noise of a truth with 64 samples. More of them cost megabytes and show nothing.
constexpr int kErrorSteps = 41;
constexpr int kErrorCentre = kErrorSteps / 2;
// With the colours that are added, at most 16: four bits a pixel.
constexpr int kMaskGrays = 12;
constexpr int kMagnitudeSteps = 15;
constexpr int kDepthSteps = 64;

Picture png_picture(const std::string& png, int width, int height) {
    return {"data:image/png;base64," + base64(png), width, height};
}

Picture indexed_picture(const Bytes& indices, const std::vector<Rgb>& colours) {
    return png_picture(encode_png_indexed(indices, colours), indices.width, indices.height);
}

/// The step of `position` in [0,1] among `steps`; 0 for NaN, which its caller colours otherwise.
std::uint8_t step_of(double position, int steps) {
    if (!(position > 0)) return 0;
    return static_cast<std::uint8_t>(std::lround(std::min(position, 1.0) * (steps - 1)));
}

Picture mapped_picture(const ImageF& values, const Mask& valid, double low, double high, ColourMap map,
                       int steps) {
    std::vector<Rgb> colours = palette(map, steps);
    const auto invalid = static_cast<std::uint8_t>(colours.size());
    colours.push_back(kInvalidColour);
    const double span = high > low ? high - low : 1.0;
    Bytes indices(values.width, values.height);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool shown = valid.pixels[i] != 0 && std::isfinite(values.pixels[i]);
        indices.pixels[i] = shown ? step_of((double{values.pixels[i]} - low) / span, steps) : invalid;
    }
    return indexed_picture(indices, colours);
}

Bytes gray_bytes(const ImageF& visibility, double step) {
    const int levels = 1 + static_cast<int>(std::lround(1 / std::clamp(step, 1.0 / 255, 1.0)));
    Bytes bytes(visibility.width, visibility.height);
    std::transform(visibility.pixels.begin(), visibility.pixels.end(), bytes.pixels.begin(), [&](float v) {
        const double rounded = step_of(double{v}, levels) / (levels - 1.0);
        return static_cast<std::uint8_t>(std::lround(rounded * 255));
    });
    return bytes;
}

}  // namespace

Picture gray_picture(const ImageF& visibility, double step) {
    return png_picture(encode_png_gray(gray_bytes(visibility, step)), visibility.width, visibility.height);
}

Picture gray_thumbnail(const ImageF& visibility, int width_px) {
    const int factor = std::max(1, (visibility.width + width_px - 1) / width_px);
    ImageF small((visibility.width + factor - 1) / factor, (visibility.height + factor - 1) / factor);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            float sum = 0, count = 0;
            for (int v = y * factor; v < std::min((y + 1) * factor, visibility.height); ++v) {
                for (int u = x * factor; u < std::min((x + 1) * factor, visibility.width); ++u) {
                    sum += visibility.at(u, v);
                    count += 1;
                }
            }
            small.at(x, y) = sum / count;
        }
    }
    return gray_picture(small);
}

Picture signed_error_picture(const ImageF& truth, const ImageF& test, const Mask& valid) {
    std::vector<Rgb> colours = palette(blue_red(), kErrorSteps);
    const auto invalid = static_cast<std::uint8_t>(colours.size());
    colours.push_back(kInvalidColour);
    const auto nonfinite = static_cast<std::uint8_t>(colours.size());
    colours.push_back(kNonfiniteColour);

    Bytes indices(truth.width, truth.height);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = double{test.pixels[i]} - double{truth.pixels[i]};
        if (!std::isfinite(error)) {
            indices.pixels[i] = nonfinite;
        } else if (valid.pixels[i] == 0) {
            indices.pixels[i] = invalid;
        } else {
            const double step = std::clamp(error / kErrorRange, -1.0, 1.0) * kErrorCentre;
            indices.pixels[i] = static_cast<std::uint8_t>(kErrorCentre + std::lround(step));
        }
    }
    return indexed_picture(indices, colours);
}

Picture mask_picture(const ImageF& truth, const Mask& missing, const Mask& false_occlusion) {
    // From mid-gray up: both colours of the masks stay darker and more saturated than what lies under them.
    static constexpr Rgb kPaleGrays[] = {0x70706e, 0xf2f2f0};
    std::vector<Rgb> colours = palette(kPaleGrays, kMaskGrays);
    const auto missing_index = static_cast<std::uint8_t>(colours.size());
    colours.push_back(kMissingOcclusionColour);
    const auto false_index = static_cast<std::uint8_t>(colours.size());
    colours.push_back(kFalseOcclusionColour);

    Bytes indices(truth.width, truth.height);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        indices.pixels[i] = missing.pixels[i] != 0           ? missing_index
                            : false_occlusion.pixels[i] != 0 ? false_index
                                                             : step_of(double{truth.pixels[i]}, kMaskGrays);
    }
    return indexed_picture(indices, colours);
}

Picture magnitude_picture(const ImageF& values, const Mask& valid, double high) {
    return mapped_picture(values, valid, 0, high, magma(), kMagnitudeSteps);
}

Picture depth_picture(const ImageF& depth_m, const Mask& valid, double low_m, double high_m) {
    return mapped_picture(depth_m, valid, low_m, high_m, viridis(), kDepthSteps);
}

}  // namespace aoscore
