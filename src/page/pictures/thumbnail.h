#pragma once

#include "core/image.h"
#include "page/pictures/pictures.h"

namespace aoscore {

/// The image reduced to at most `width_px` wide: each pixel is the mean of the square it covers, NaN where
/// one pixel is.
ImageF shrunk(const ImageF& image, int width_px);

/// Visibility as 8-bit gray, 0 black, 1 white, linear in the number, not in light; at most `width_px` wide,
/// reduced as by shrunk().
Picture gray_thumbnail(const ImageF& visibility, int width_px);

}  // namespace aoscore
