#include "metrics/analysis/tile_pattern.h"

#include "metrics/measures/bands.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr int kNearest_px = kTile_px - 2, kFarthest_px = kTile_px + 2;
constexpr std::size_t kDistances = kFarthest_px - kNearest_px + 1;

/// A row of errors, 0 where a pixel is not valid, and 1 where it is.
struct PaddedErrorRow {
    std::vector<double> errors, valid;

    void read(const MetricInput& input, int y) {
        const std::size_t first = input.valid.index(0, y),
                          width = static_cast<std::size_t>(input.valid.width);
        errors.resize(width);
        valid.resize(width);
        for (std::size_t x = 0; x < width; ++x) {
            const bool counts = input.valid.pixels[first + x] != 0;
            valid[x] = counts ? 1 : 0;
            errors[x] =
                counts ? double{input.test.pixels[first + x]} - double{input.truth.pixels[first + x]} : 0.0;
        }
    }
};

/// The sum of squared differences over pairs of valid pixels, and their number.
struct PairSum {
    double squared = 0, count = 0;
    void add(const PairSum& other) {
        squared += other.squared;
        count += other.count;
    }
};
using SumsByDistance = std::array<PairSum, kDistances>;

/// The sum over the pairs a[i] and b[i].
AOSCORE_WIDER_WHERE_POSSIBLE
void add_pairs(const double* a, const double* a_valid, const double* b, const double* b_valid,
               std::size_t count, PairSum& sum) {
    Lanes squared{}, pairs{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes x, y, x_valid, y_valid;
        load(x, a + i);
        load(y, b + i);
        load(x_valid, a_valid + i);
        load(y_valid, b_valid + i);
        const Lanes both = x_valid * y_valid;
        squared += both * ((x - y) * (x - y));
        pairs += both;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) sum.add({squared[lane], pairs[lane]});
    for (; i < count; ++i) {
        const double both = a_valid[i] * b_valid[i];
        sum.add({both * ((a[i] - b[i]) * (a[i] - b[i])), both});
    }
}

/// The sums over pairs across and down that begin in some rows of the image. Only the last rows are kept.
SumsByDistance sums_of_rows(const MetricInput& input, int first_row, int rows) {
    constexpr std::size_t kKept = kFarthest_px + 1;
    const int height = input.valid.height;
    std::array<PaddedErrorRow, kKept> kept;
    const auto row = [&](int y) -> PaddedErrorRow& { return kept[static_cast<std::size_t>(y) % kKept]; };
    SumsByDistance sums;
    for (int y = first_row; y < std::min(first_row + kFarthest_px, height); ++y) row(y).read(input, y);
    for (int y = first_row; y < first_row + rows; ++y) {
        if (y + kFarthest_px < height) row(y + kFarthest_px).read(input, y + kFarthest_px);
        const PaddedErrorRow& here = row(y);
        for (std::size_t d = 0; d < kDistances; ++d) {
            const std::size_t distance = kNearest_px + d, width = here.errors.size();
            if (distance < width)
                add_pairs(here.errors.data(), here.valid.data(), here.errors.data() + distance,
                          here.valid.data() + distance, width - distance, sums[d]);
            if (y + static_cast<int>(distance) >= height) continue;
            const PaddedErrorRow& below = row(y + static_cast<int>(distance));
            add_pairs(here.errors.data(), here.valid.data(), below.errors.data(), below.valid.data(), width,
                      sums[d]);
        }
    }
    return sums;
}

/// The sums over all pairs of valid pixels at each distance, across and down.
SumsByDistance sums_by_distance(const MetricInput& input) {
    std::vector<SumsByDistance> bands(band_count(input.valid.height));
    for_each_band(input.valid.height, [&](std::size_t band, int first_row, int rows) {
        bands[band] = sums_of_rows(input, first_row, rows);
    });
    SumsByDistance all;
    for (const SumsByDistance& band : bands) {
        for (std::size_t d = 0; d < kDistances; ++d) all[d].add(band[d]);
    }
    return all;
}

}  // namespace

std::optional<double> tile_pattern(const MetricInput& input) {
    require_one_size(input);
    const SumsByDistance sums = sums_by_distance(input);
    if (std::ranges::any_of(sums, [](const PairSum& sum) { return sum.count == 0; })) return std::nullopt;
    // The value at the tile's distance of the cubic through the distances about it.
    double without_pattern = 0;
    for (const auto& [distance_px, weight] :
         {std::pair(kTile_px - 2, -1.0), {kTile_px - 1, 4.0}, {kTile_px + 1, 4.0}, {kTile_px + 2, -1.0}}) {
        const PairSum& beside = sums[static_cast<std::size_t>(distance_px - kNearest_px)];
        without_pattern += weight / 6 * (beside.squared / beside.count);
    }
    const PairSum& at_tile = sums[kTile_px - kNearest_px];
    const double dip = without_pattern - at_tile.squared / at_tile.count;
    return std::sqrt(std::max(dip, 0.0) / 2);
}

}  // namespace aoscore
