#pragma once

#include "metrics/intervals/block_errors.h"

#include <map>
#include <string>

namespace aoscore {

/// What a value with 95 % confidence lies away from the one against a truth without noise, by metric id: for
/// those metrics that have the noise taken off or extrapolated away. `whole` are the sums against the truth,
/// the others against each of its two halves.
///
/// The noise of distant blocks is independent and has no sign, so that a block's sums could as well have
/// moved the other way: the sum of squares of what half the difference of the halves moves the value, block
/// by block, is the variance that noise gives it. Blocks that touch share the window of a metric, and are
/// taken together. What is extrapolated errs by terms of higher order, too: by a part of what the
/// extrapolation took off, which was measured on four scenes (tests/jobs/few_rays_score_test.cpp). It falls
/// with the noise's variance where the metric is smooth, as SSIM (a picture of constant
/// variance v on flat ground would leave 2 v / C2 of it, C2 = 0.0009; 3 v / C2 are allowed for);
/// where it has a kink at no difference, as FLIP, a part stays.
std::map<std::string, double> truth_noise(const BlockErrors& whole, const BlockErrors& first,
                                          const BlockErrors& second);

}  // namespace aoscore
