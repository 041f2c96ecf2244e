#pragma once

#include "metrics/intervals/block_errors.h"

#include <map>
#include <string>

namespace aoscore {

/// The half width of a value's distance from the one against a truth without noise, with 95 % confidence, by
/// metric id, for metrics whose noise is subtracted or extrapolated. `whole` holds the sums against the
/// truth, `first` and `second` those against each of its two `halves`. Where these lack the noisy sums or the
/// number of rays, a metric that needs them has no half width.
///
/// The noise of distant blocks is independent, and its sign is random. Half the difference of the halves
/// changes the value by some amount in each block, and the sum of the squares of these changes is the
/// variance by noise, that of the extrapolation included: where f' and f'' are the derivatives of the value
/// by the truth, n is the truth's noise and d half the difference of the halves, the extrapolated value moves
/// by f' n + f'' (n^2 - d^2) / 2, and half the difference of the halves' values is f' d + f'' n d, whose
/// variance is the same. Adjacent blocks share the window of a metric, and are taken together. Extrapolated
/// values also have errors of higher order, which differ from scene to scene but not from seed to seed. They
/// are a part of the extrapolation's correction, or of all that the noise did (Metric::left_always,
/// left_by_deviation, left_by_noise, root mean square over scenes), and their variance is added to that by
/// noise: over many scenes 95 of 100 intervals hold the converged value, though not the same share on each.
std::map<std::string, double> truth_noise(const BlockErrors& whole, const BlockErrors& first,
                                          const BlockErrors& second, const TruthHalves& halves);

}  // namespace aoscore
