#pragma once

#include "metrics/intervals/block_errors.h"

#include <map>
#include <string>

namespace aoscore {

/// The half width of a value's distance from the one against a truth without noise, with 95 % confidence, by
/// metric id, for metrics whose noise is subtracted or extrapolated. `whole` holds the sums against the
/// truth, the others those against each of its two halves.
///
/// The noise of distant blocks is independent, and its sign is random. Half the difference of the halves
/// changes the value by some amount in each block, and the sum of the squares of these changes is the
/// variance by noise. Adjacent blocks share the window of a metric, and are taken together. Extrapolated
/// values also have errors of higher order, a part of the extrapolation's correction, which was measured on
/// four scenes (tests/jobs/few_rays_score_test.cpp). For a smooth metric such as SSIM that part falls with
/// the noise's variance (a picture of constant variance v on flat ground would keep 2 v / C2 of it, C2 =
/// 0.0009; 3 v / C2 are allowed); for one with a kink at zero difference, such as FLIP, a part remains.
std::map<std::string, double> truth_noise(const BlockErrors& whole, const BlockErrors& first,
                                          const BlockErrors& second);

}  // namespace aoscore
