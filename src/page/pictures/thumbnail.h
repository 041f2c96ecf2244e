#pragma once

#include "core/image.h"
#include "page/pictures/pictures.h"

namespace aoscore {

/// At most `width_px` wide: each pixel the mean of the square it covers, which is no number where one of
/// them is none.
ImageF shrunk(const ImageF& image, int width_px);

/// Visibility as 8-bit gray, 0 black, 1 white, linear in the number, not in light; at most `width_px` wide,
/// each pixel the mean of the square it covers.
Picture gray_thumbnail(const ImageF& visibility, int width_px);

}  // namespace aoscore
