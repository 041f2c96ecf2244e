#include "core/threads.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures.h"
#include "metrics/measures/flip_colour.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/seen_rows.h"
#include "metrics/measures/wide_lanes.h"
#include "metrics/prepared_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

// After Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild,
// "FLIP: A Difference Evaluator for Alternating Images", 2020, for gray images.
namespace aoscore {
namespace {

/// The sum over the pixels that count; the others may be NaN.
AOSCORE_WIDER_WHERE_POSSIBLE
double sum_where(const std::uint8_t* valid, const double* map, std::size_t count) {
    Lanes sums{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes values;
        load(values, map + i);
        replace_invalid(values, valid + i);
        sums += values;
    }
    double sum = sum_of(sums);
    for (; i < count; ++i) sum += valid[i] != 0 ? map[i] : 0;
    return sum;
}

std::unique_ptr<SeenRows> rows_of(const ImageF& image, const PreparedImage* prepared, ValidRows& valid) {
    if (prepared != nullptr) return std::make_unique<StoredRows>(prepared->seen(), valid.area());
    return std::make_unique<FilteredRows>(image, valid);
}

/// Adds FLIP's map over the valid pixels of an area, by block.
void add_area(const MetricInput& input, const ImageArea& area, std::vector<double>& sums,
              const BlockGrid& grid) {
    ValidRows valid_rows(input.valid, area);
    const auto truth_rows = rows_of(input.truth, input.prepared_truth, valid_rows);
    const auto test_rows = rows_of(input.test, input.prepared_test, valid_rows);
    std::vector<double> map(static_cast<std::size_t>(area.width));
    for (int y = area.top; y < area.top + area.height; ++y) {
        flip_differences(map, truth_rows->next(), test_rows->next());
        const std::uint8_t* valid = &input.valid.at(0, y);
        grid.for_each_piece(
            y, area.left, area.left + area.width, 0, [&](std::size_t block, int from, int to) {
                sums[block] += sum_where(valid + from, &map[static_cast<std::size_t>(from - area.left)],
                                         static_cast<std::size_t>(to - from));
            });
    }
}

}  // namespace

MetricValue measure::flip(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    if (!mse) return undefined(kNoValidPixel);
    if (!std::isfinite(*mse)) return undefined(kNotFinite);  // checked before infinity is clamped to 1
    // Prepares the images before several threads read them.
    for (const PreparedImage* prepared : {input.prepared_truth, input.prepared_test}) {
        if (prepared != nullptr) prepared->seen();
    }
    const BlockGrid grid(input.truth.width, input.truth.height);
    const std::vector<ImageArea> areas = image_areas(input.truth.width, input.truth.height);
    std::vector<std::vector<double>> of_areas(areas.size(), std::vector<double>(grid.size()));
    parallel_for(areas.size(), [&](std::size_t i) { add_area(input, areas[i], of_areas[i], grid); });
    std::vector<double> sums;
    for (const std::vector<double>& area : of_areas) add_sums(sums, area);
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    const auto count = static_cast<double>(
        std::ranges::count_if(input.valid.pixels, [](std::uint8_t valid) { return valid != 0; }));
    if (input.maps != nullptr) input.maps->flip_sums = std::move(sums);
    return defined(sum / count);
}

}  // namespace aoscore
