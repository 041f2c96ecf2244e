#pragma once

#include "core/image.h"

namespace aoscore {

/// No picture of a stress test is kept larger than this, pixels a side.
inline constexpr int kStressThumbnail_px = 64;

/// Steps between 0 and 1 that are kept of a picture and of a difference, so that files stay small.
inline constexpr int kPictureSteps = 255, kDifferenceSteps = 127;

/// The picture at most kStressThumbnail_px wide and high, each pixel the mean of those it covers and NaN
/// where one of them is not finite, in steps of 1/`steps`.
ImageF stress_thumbnail(const ImageF& image, int steps);

}  // namespace aoscore
