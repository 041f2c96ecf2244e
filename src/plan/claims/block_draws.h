#pragma once

#include "plan/claims/quantity.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace aoscore {

/// A value of sums over all blocks of a picture, with draws of blocks with replacement, as resampled() draws
/// those of one picture: values of one view are paired, draw by draw. `of` are sums by block, of one size.
/// Empty where the value is not finite.
Measured over_blocks(const std::vector<const std::vector<double>*>& of,
                     const std::function<double(const std::vector<double>& sums)>& value_of,
                     std::uint64_t seed);

}  // namespace aoscore
