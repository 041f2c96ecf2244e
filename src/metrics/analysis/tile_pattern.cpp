#include "metrics/analysis/tile_pattern.h"

#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

/// Mean squared difference of the errors of valid pixels at this distance, across and down; empty without
/// any.
std::optional<double> squared_difference(const MetricInput& input, int distance_px) {
    const ImageF& truth = input.truth;
    const auto error = [&](std::size_t i) {
        return static_cast<double>(input.test.pixels[i]) - static_cast<double>(truth.pixels[i]);
    };
    double sum = 0, count = 0;
    const auto add = [&](std::size_t one, std::size_t other) {
        if (input.valid.pixels[one] == 0 || input.valid.pixels[other] == 0) return;
        const double difference = error(one) - error(other);
        sum += difference * difference;
        ++count;
    };
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const std::size_t here = truth.index(x, y);
            if (x + distance_px < truth.width) add(here, truth.index(x + distance_px, y));
            if (y + distance_px < truth.height) add(here, truth.index(x, y + distance_px));
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

std::optional<double> tile_pattern(const MetricInput& input) {
    require_one_size(input);
    // What the cubic through the distances about the tile's gives at the tile's.
    double without_pattern = 0;
    for (const auto& [step_px, weight] : {std::pair(-2, -1.0), {-1, 4.0}, {1, 4.0}, {2, -1.0}}) {
        const std::optional<double> beside = squared_difference(input, kTile_px + step_px);
        if (!beside) return std::nullopt;
        without_pattern += weight / 6 * *beside;
    }
    const double dip = without_pattern - *squared_difference(input, kTile_px);
    return std::sqrt(std::max(dip, 0.0) / 2);
}

}  // namespace aoscore
