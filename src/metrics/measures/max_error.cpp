#include "core/error.h"
#include "core/threads.h"
#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace aoscore {
namespace {

constexpr double kNone = -1;  ///< less than the size of any error

/// The size of the largest error of a row; infinite where one is not finite, and kNone without a valid pixel.
AOSCORE_WIDER_WHERE_POSSIBLE
double largest_of_row(const float* truth, const float* test, const std::uint8_t* valid, std::size_t count) {
    constexpr double kMost = std::numeric_limits<double>::max();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Lanes most = Lanes{} + kNone;
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes of_truth, error;
        load(of_truth, truth + i);
        load(error, test + i);
        error -= of_truth;
        take_sign_off(error);
        error = error <= kMost ? error : Lanes{} + kInfinite;
        replace_invalid(error, valid + i, kNone);
        most = error > most ? error : most;
    }
    double largest = kNone;
    for (std::size_t lane = 0; lane < kLanes; ++lane) largest = std::max(largest, most[lane]);
    for (; i < count; ++i) {
        if (valid[i] == 0) continue;
        const double error = std::abs(double{test[i]} - double{truth[i]});
        largest = std::max(largest, error <= kMost ? error : kInfinite);
    }
    return largest;
}

/// The first valid pixel of a row with this error.
int place_of(double error, const MetricInput& input, int y) {
    for (int x = 0; x < input.valid.width; ++x) {
        const double found = std::abs(double{input.test.at(x, y)} - double{input.truth.at(x, y)});
        if (input.valid.at(x, y) != 0 && found == error) return x;
    }
    throw internal_error("the largest error of a row is none of its own");
}

}  // namespace

MetricValue measure::max_error(const MetricInput& input) {
    require_one_size(input);
    std::vector<double> rows(static_cast<std::size_t>(input.valid.height));
    const auto width = static_cast<std::size_t>(input.valid.width);
    parallel_for(rows.size(), [&](std::size_t y) {
        const std::size_t first = y * width;
        rows[y] = largest_of_row(input.truth.pixels.data() + first, input.test.pixels.data() + first,
                                 input.valid.pixels.data() + first, width);
    });
    const auto worst = std::ranges::max_element(rows);
    if (worst == rows.end() || *worst < 0) return undefined(kNoValidPixel);
    if (!std::isfinite(*worst)) return undefined(kNotFinite);
    const int y = static_cast<int>(worst - rows.begin()), x = place_of(*worst, input, y);
    return defined(*worst, fmt::format("at pixel {}, {}: truth {:.4g}, test {:.4g}", x, y,
                                       input.truth.at(x, y), input.test.at(x, y)));
}

}  // namespace aoscore
