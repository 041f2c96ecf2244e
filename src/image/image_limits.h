#pragma once

#include "core/error.h"
#include "core/memory_budget.h"

#include <cstdint>
#include <string>

namespace aoscore {

/// Checks a header's claims before anything is allocated for them: throws file_error for an empty image, and
/// for more than kLargestImageSide_px pixels a side, 1024 channels, or 2^30 values.
void require_allocatable(int width, int height, int channels, const std::string& where);

/// Whether a texture of this size may be decoded: at most 8192 pixels a side and 4 channels, within what is
/// left of the budget, from which it is taken. `reason` says why not.
bool texture_fits(std::int64_t width, std::int64_t height, int channels, MemoryBudget& budget,
                  std::string& reason);

/// Makes an error of one line from a library's complaint, which may span lines and name the file again on
/// each.
Error unreadable_image(const std::string& complaint, const std::string& where);

}  // namespace aoscore
