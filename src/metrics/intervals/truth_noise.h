#pragma once

#include "metrics/intervals/block_errors.h"

#include <map>
#include <string>

namespace aoscore {

/// The half width of a value's distance from the one against a truth without noise, with 95 % confidence, by
/// metric id, for metrics whose noise is subtracted or extrapolated. `whole` holds the sums against the
/// truth, the others those against each of its two halves, and `noisier` those against
/// PreparedHalves::noisier.
///
/// The noise of distant blocks is independent, and its sign is random. Half the difference of the halves
/// changes the value by some amount in each block, and the sum of the squares of these changes is the
/// variance by noise. Adjacent blocks share the window of a metric, and are taken together. Extrapolated
/// values also have errors of higher order, a part of the extrapolation's correction, which was measured on
/// four scenes (tests/jobs/few_rays_score_test.cpp): for metrics with a kink at zero difference, such as
/// FLIP, a part remains. SSIM and MS-SSIM, whose windows' variances the noise is taken off, may be wrong by
/// what `noisier` changes.
std::map<std::string, double> truth_noise(const BlockErrors& whole, const BlockErrors& first,
                                          const BlockErrors& second, const MapSums& noisier);

}  // namespace aoscore
