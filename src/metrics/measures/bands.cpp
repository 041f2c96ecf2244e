#include "metrics/measures/bands.h"

#include "core/threads.h"

#include <algorithm>

namespace aoscore {
namespace {

// The height of a band: large enough that rows read twice by neighbours cost little, small enough for its
// planes to stay in cache.
constexpr int kBandRows = 64;

}  // namespace

std::size_t band_count(int height) {
    return static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
}

void for_each_band(int height, const std::function<void(std::size_t, int, int)>& body) {
    parallel_for(band_count(height), [&](std::size_t band) {
        const int first = static_cast<int>(band) * kBandRows;
        body(band, first, std::min(kBandRows, height - first));
    });
}

}  // namespace aoscore
