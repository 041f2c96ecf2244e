#pragma once

#include "core/image.h"
#include "image/image_file.h"
#include "page/pictures/pictures.h"

#include <array>
#include <filesystem>
#include <string>

namespace aoscore {

/// Red, green and blue of irradiance over pi, linear.
using ColourPlanes = std::array<ImageF, 3>;

/// The three channels of an image file, whose path is `path`. Throws file_error where one is missing.
ColourPlanes colour_planes(const ImageFile& file, const std::filesystem::path& path,
                           const std::array<std::string, 3>& channels);

/// The luminance of colours.
ImageF luminance_of(const ColourPlanes& colours);

/// The largest of red, green and blue in each pixel.
ImageF largest_of(const ColourPlanes& colours);

/// Makes a picture, at most `width_px` wide: colours are divided by `white` and coded as sRGB. A colour with
/// a component above 1 is divided by that as a whole, so that it keeps its hue.
Picture lit_picture(const ColourPlanes& colours, double white, int width_px);

/// Errors from -kLitErrorRange to kLitErrorRange of the mean of the truth are told apart.
inline constexpr double kLitErrorRange = 0.5;

/// Makes a picture, at most `width_px` wide, of by how much the luminance exceeds the truth's, as part of
/// `mean`, the truth's mean: blue where it is too dark, red where it is too bright, gray where `valid` is 0.
Picture lit_error_picture(const ColourPlanes& colours, const ImageF& truth, double mean, const Mask& valid,
                          int width_px);

}  // namespace aoscore
