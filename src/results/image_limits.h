#pragma once

#include <string>

namespace aoscore {

/// Refuses what a header claims before anything is allocated for it: throws file_error for an empty image,
/// more than kLargestImageSide_px pixels a side, 1024 channels, or 2^30 values.
void require_allocatable(int width, int height, int channels, const std::string& where);

}  // namespace aoscore
