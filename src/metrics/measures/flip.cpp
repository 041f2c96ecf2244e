#include "core/threads.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures.h"
#include "metrics/measures/flip_colour.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/power.h"
#include "metrics/measures/seen_rows.h"
#include "metrics/measures/wide_lanes.h"
#include "metrics/prepared_image.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

// After Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild,
// "FLIP: A Difference Evaluator for Alternating Images", 2020, for gray images.
namespace aoscore {
namespace {

/// The exponents of FLIP's colour differences, which come nearer to 0 as features of two pixels differ more.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_exponents(const SeenRow& truth, const SeenRow& test, std::vector<double>& exponents) {
    double* exponent = exponents.data();
    const std::size_t count = exponents.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double feature =
            std::max(std::abs(truth.edges[i] - test.edges[i]), std::abs(truth.points[i] - test.points[i]));
        exponent[i] = std::max(1 - std::sqrt(feature / std::numbers::sqrt2), 0.0);
    }
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
    std::vector<double> map(static_cast<std::size_t>(area.width)), exponents(map);
    for (int y = area.top; y < area.top + area.height; ++y) {
        const SeenRow truth = truth_rows->next(), test = test_rows->next();
        flip_color_differences(map, truth.lightness, test.lightness);
        find_exponents(truth, test, exponents);
        raise(map, exponents);
        const std::uint8_t* valid = &input.valid.at(0, y);
        grid.for_each_piece(y, area.left, area.left + area.width, 0,
                            [&](std::size_t block, int from, int to) {
                                for (int x = from; x < to; ++x) {
                                    if (valid[x] != 0)
                                        sums[block] += map[static_cast<std::size_t>(x - area.left)];
                                }
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
