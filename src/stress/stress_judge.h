#pragma once

#include "core/image.h"
#include "results/stress_results.h"
#include "stress/stress_axes.h"

namespace aoscore {

/// A larger deviation than these breaks. Where exact arithmetic gives the same picture, only rounding
/// remains, and the limit is a root mean square of 0.02, a fiftieth of the range. Where the picture changes,
/// a method may do somewhat worse for many reasons, and the limit is 0.05.
inline constexpr double kSamePictureLimit = 0.02;
inline constexpr double kErrorLimit = 0.05;
/// With fewer pixels to compare, a mean square is not meaningful.
inline constexpr std::size_t kLeastComparedPixels = 400;

double stress_limit(StressJudgement judgement);

/// A stressed picture, with the data by which it is judged.
struct StressedPicture {
    const ImageF& visibility;
    const Mask& surface;                     ///< pixels where anything was drawn, or hit
    const Mask& valid;                       ///< pixels where both paths see the same surface
    const ImageF* truth = nullptr;           ///< the subject's own; null where the view is not traced
    const ImageF* standard_error = nullptr;  ///< the truth's
};

/// A subject's picture where nothing is stressed, with its numbers.
struct UnstressedPicture {
    ImageF visibility;
    Mask valid;
    std::optional<double> rmse, mean;  ///< as in StressCell
};

/// Checks the rules for any picture: fills nonfinite, out_of_range, background and mean.
void count_faults(const StressedPicture& picture, StressCell& cell);

/// Root mean square of picture - base where both are valid and finite; the difference itself goes to
/// `difference` (0 elsewhere). Empty with fewer than kLeastComparedPixels.
std::optional<double> same_picture_deviation(const StressedPicture& picture, const ImageF& base,
                                             const Mask& base_valid, ImageF& difference);

/// Root of the mean square error against the own truth less the truth's mean variance; the error itself goes
/// to `difference` (0 elsewhere). Empty with fewer than kLeastComparedPixels.
std::optional<double> debiased_error(const StressedPicture& picture, ImageF& difference);

/// Fills in the deviation from the unstressed picture, and the error where the axis is judged by that.
/// `difference` becomes the image whose mean square the deviation is, and stays empty without truth.
void compare_with_unstressed(StressJudgement judgement, const StressedPicture& picture,
                             const UnstressedPicture& unstressed, StressCell& cell, ImageF& difference);

/// Names the faults in cell.breaks, the worst first.
void judge(StressJudgement judgement, StressCell& cell);

}  // namespace aoscore
