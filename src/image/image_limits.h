#pragma once

#include "core/error.h"

#include <string>

namespace aoscore {

/// Refuses what a header claims before anything is allocated for it: throws file_error for an empty image,
/// more than kLargestImageSide_px pixels a side, 1024 channels, or 2^30 values.
void require_allocatable(int width, int height, int channels, const std::string& where);

/// A library's complaint about an image, which may span lines and name the file again on each, as an error of
/// one line.
Error unreadable_image(const std::string& complaint, const std::string& where);

}  // namespace aoscore
