#pragma once

#include "core/image.h"
#include "report/pictures.h"

namespace aoscore {

/// Visibility as 8-bit gray, 0 black, 1 white, linear in the number, not in light. Values are rounded to
/// multiples of `step`, or of 1/255 where that is more: digits below the truth's noise cost megabytes and
/// tell nothing.
Picture gray_picture(const ImageF& visibility, double step = 0);

/// The same, at most `width_px` wide, each pixel the mean of the square it covers.
Picture gray_thumbnail(const ImageF& visibility, int width_px);

/// test - truth on blue_red over ±kErrorRange; invalid and non-finite pixels in colours of their own.
Picture signed_error_picture(const ImageF& truth, const ImageF& test, const Mask& valid);

/// The truth in pale gray, with missing and false occlusion laid over it.
Picture mask_picture(const ImageF& truth, const Mask& missing, const Mask& false_occlusion);

/// Values from `low` to `high` on magma (magnitudes) in few steps, since they are noise for the most part.
Picture magnitude_picture(const ImageF& values, const Mask& valid, double high);
/// Values from `low` to `high` on viridis.
Picture depth_picture(const ImageF& depth_m, const Mask& valid, double low_m, double high_m);

}  // namespace aoscore
