#pragma once

#include "core/image.h"

namespace aoscore {

/// The largest side of a stored picture, in pixels.
inline constexpr int kStressThumbnail_px = 64;

/// The number of steps between 0 and 1 in stored pictures and differences, so that files stay small.
inline constexpr int kPictureSteps = 255, kDifferenceSteps = 127;

/// Reduces the picture to at most kStressThumbnail_px a side, in steps of 1/`steps`. Each pixel is the mean
/// of those it covers, and NaN where one of them is not finite.
ImageF stress_thumbnail(const ImageF& image, int steps);

}  // namespace aoscore
