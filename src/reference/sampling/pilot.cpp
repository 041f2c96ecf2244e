#include "reference/sampling/pilot.h"

#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

/// Of the tiles, and never fewer than so many, where there are so many.
constexpr double kPilotPart = 1.0 / 64;
constexpr std::size_t kLeastTiles = 256;
/// Error falls about as N^-3/4.
constexpr double kSamplesPerError = 4.0 / 3;

/// The gain of another ray a pixel at a step; it falls from step to step.
double gain_of(const ErrorStep& step, const TileConvergence& convergence) {
    return step.error_sum / static_cast<double>(convergence.traced) / step.samples;
}

/// The sum at the step where a tile stops.
double error_sum_at(const TileConvergence& convergence, double least_gain) {
    for (const ErrorStep& step : convergence.steps) {
        if (gain_of(step, convergence) <= least_gain) return step.error_sum;
    }
    return convergence.steps.empty() ? 0 : convergence.steps.back().error_sum;
}

double mean_error_at(const std::vector<TileConvergence>& convergences, double least_gain) {
    double sum = 0, surfaces = 0;
    for (const TileConvergence& convergence : convergences) {
        sum += error_sum_at(convergence, least_gain);
        surfaces += static_cast<double>(convergence.surfaces);
    }
    return surfaces > 0 ? sum / surfaces : 0;
}

/// The highest gain, among those at which some tile stops earlier, that is low enough.
double highest_gain(const std::vector<TileConvergence>& convergences, double mean_error) {
    std::vector<double> gains;
    for (const TileConvergence& convergence : convergences) {
        for (const ErrorStep& step : convergence.steps) gains.push_back(gain_of(step, convergence));
    }
    std::sort(gains.begin(), gains.end());
    const auto too_high = std::partition_point(gains.begin(), gains.end(), [&](double least_gain) {
        return mean_error_at(convergences, least_gain) <= mean_error;
    });
    return too_high == gains.begin() ? 0 : *(too_high - 1);
}

}  // namespace

double gain_for_mean_error(double mean_error, int width, int height, const TraceTileTo& trace_to) {
    const auto part =
        static_cast<std::size_t>(kPilotPart * static_cast<double>(tiles_of(width, height).size()));
    const std::vector<Tile> tiles = random_tiles(width, height, std::max(part, kLeastTiles));
    std::vector<TileConvergence> convergences(tiles.size());
    const auto trace_all_to = [&](double least_gain) {
        parallel_for(tiles.size(), [&](std::size_t i) { convergences[i] = trace_to(tiles[i], least_gain); });
        return mean_error_at(convergences, least_gain);
    };
    double least_gain = std::numeric_limits<double>::infinity();
    const double first_error = trace_all_to(least_gain);
    if (first_error <= mean_error) return least_gain;
    int first = 0;
    for (const TileConvergence& convergence : convergences) {
        if (!convergence.steps.empty()) first = convergence.steps.front().samples;
    }
    // By the law of the error, and a little lower, so that the gain lies within what is traced.
    least_gain = mean_error / (first * std::pow(first_error / mean_error, kSamplesPerError)) / 2;
    for (int round = 0; trace_all_to(least_gain) > mean_error; ++round) {
        constexpr int kMostRounds = 24;  // a tile that has all the rays there are errs as it does
        if (round == kMostRounds) return least_gain;
        least_gain /= 2;
    }
    return highest_gain(convergences, mean_error);
}

}  // namespace aoscore
