#pragma once

#include "core/image.h"
#include "results/stress_results.h"
#include "stress/stress_axes.h"

namespace aoscore {

/// A deviation beyond these breaks. Where exact arithmetic gives the same picture, only rounding is left: a
/// root mean square of 0.02 is a fiftieth of the range. Where the picture changes, a method may do somewhat
/// worse for many reasons: 0.05.
inline constexpr double kSamePictureLimit = 0.02;
inline constexpr double kErrorLimit = 0.05;
/// A picture with fewer pixels to compare says nothing by its mean square.
inline constexpr std::size_t kLeastComparedPixels = 400;

double stress_limit(StressJudgement judgement);

/// A picture under judgement, and what is known about it.
struct StressedPicture {
    const ImageF& visibility;
    const Mask& surface;                     ///< where anything was drawn, or hit
    const Mask& valid;                       ///< where ray tracer and rasteriser see the same surface
    const ImageF* truth = nullptr;           ///< the subject's own; null where the view is not traced
    const ImageF* standard_error = nullptr;  ///< of it
};

/// A subject's picture where nothing is stressed, and what is known about it.
struct UnstressedPicture {
    ImageF visibility;
    Mask valid;
    std::optional<double> rmse, mean;  ///< as StressCell has them
};

/// What must hold for any picture: fills nonfinite, out_of_range, background and mean.
void count_faults(const StressedPicture& picture, StressCell& cell);

/// Root mean square of picture - base where both are valid and finite; the difference itself goes to
/// `difference` (0 elsewhere). Empty with fewer than kLeastComparedPixels.
std::optional<double> same_picture_deviation(const StressedPicture& picture, const ImageF& base,
                                             const Mask& base_valid, ImageF& difference);

/// Root of the mean square error against the own truth less the truth's mean variance; the error itself goes
/// to `difference` (0 elsewhere). Empty with fewer than kLeastComparedPixels.
std::optional<double> debiased_error(const StressedPicture& picture, ImageF& difference);

/// Fills in how far the picture deviates from the unstressed one, and its error where the axis is judged by
/// that; `difference` is what the deviation is made of, and stays empty where there is no truth.
void compare_with_unstressed(StressJudgement judgement, const StressedPicture& picture,
                             const UnstressedPicture& unstressed, StressCell& cell, ImageF& difference);

/// Says in cell.breaks what is wrong, the worst first.
void judge(StressJudgement judgement, StressCell& cell);

}  // namespace aoscore
