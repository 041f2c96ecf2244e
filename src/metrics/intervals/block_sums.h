#pragma once

#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/drawn_sums.h"

#include <vector>

namespace aoscore {

/// The sums of each block, without MS-SSIM. Sums that the image lacks are NaN.
std::vector<DrawnSums> sums_of_blocks(const BlockErrors& image);

}  // namespace aoscore
