#pragma once

#include <cstddef>
#include <functional>

namespace aoscore {

/// Calls body(band, first_row, rows) for fixed bands of rows on all cores; returns how many bands there are
/// for a height, so that sums of bands can be kept and added in order.
std::size_t band_count(int height);
void for_each_band(int height, const std::function<void(std::size_t band, int first_row, int rows)>& body);

}  // namespace aoscore
