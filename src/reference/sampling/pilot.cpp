#include "reference/sampling/pilot.h"

#include "core/sampling.h"
#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace aoscore {
namespace {

/// Of the tiles, and never fewer than so many, where there are so many.
constexpr double kPilotPart = 1.0 / 64;
constexpr std::size_t kLeastTiles = 128;
/// Stated errors fall by so much as rays are doubled, see TileLaw.
const double kErrorPower = std::log2(std::sqrt(0.373));
/// The time of rays that are traced at once grows about as N^0.85, as measured from 16 to 256 rays a pixel on
/// the atrium, and on no other scene.
constexpr double kTimePower = 0.85;
/// So many doublings beyond what was traced are foreseen by the law of the error.
constexpr int kForeseen = 3;

double ratio(int a, int b) {
    return static_cast<double>(a) / b;
}

double time_of(int samples) {
    return std::pow(samples, kTimePower);
}

/// The gain of another ray a pixel at a step; it falls from step to step.
double gain_of(const ErrorStep& step, const TileConvergence& convergence) {
    return step.error_sum / static_cast<double>(convergence.traced) / step.samples;
}

/// The step where a tile stops that begins with so many rays.
const ErrorStep& step_at(const TileConvergence& convergence, const RaySpread& spread) {
    for (const ErrorStep& step : convergence.steps) {
        if (step.samples >= spread.first && gain_of(step, convergence) <= spread.least_gain) return step;
    }
    return convergence.steps.back();
}

/// What a spread comes to on the tiles of a pilot.
struct Outcome {
    double mean_error = 0, time = 0;
};

Outcome outcome_of(const std::vector<TileConvergence>& tiles, const RaySpread& spread) {
    double errors = 0, surfaces = 0, time = 0;
    for (const TileConvergence& tile : tiles) {
        surfaces += static_cast<double>(tile.surfaces);
        if (tile.steps.empty()) continue;
        const ErrorStep& last = step_at(tile, spread);
        errors += last.error_sum;
        time +=
            static_cast<double>(tile.traced) * (time_of(spread.first) + time_of(last.samples - spread.first));
    }
    return {surfaces > 0 ? errors / surfaces : 0, time};
}

/// The highest gain, among those at which some tile stops earlier, that is low enough; the lowest of them
/// where none is.
double highest_gain(const std::vector<TileConvergence>& tiles, int first, double mean_error) {
    std::vector<double> gains{std::numeric_limits<double>::infinity()};
    for (const TileConvergence& tile : tiles) {
        for (const ErrorStep& step : tile.steps) {
            if (step.samples >= first) gains.push_back(gain_of(step, tile));
        }
    }
    std::sort(gains.begin(), gains.end());
    const auto too_high = std::partition_point(gains.begin(), gains.end(), [&](double least_gain) {
        return outcome_of(tiles, {first, least_gain}).mean_error <= mean_error;
    });
    return too_high == gains.begin() ? gains.front() : *(too_high - 1);
}

/// The errors at every power of two of rays: by the law of the error from the step before and the one after,
/// or from the last one.
void fill_gaps(TileConvergence& tile, int most) {
    std::vector<ErrorStep> all;
    for (std::size_t i = 0; i < tile.steps.size(); ++i) {
        const bool is_last = i + 1 == tile.steps.size();
        const ErrorStep step = tile.steps[i];
        const int end = is_last ? std::min(most, step.samples << kForeseen) : tile.steps[i + 1].samples / 2;
        double power = kErrorPower;
        if (!is_last && step.error_sum > 0 && tile.steps[i + 1].error_sum > 0)
            power = std::log(tile.steps[i + 1].error_sum / step.error_sum) /
                    std::log(ratio(tile.steps[i + 1].samples, step.samples));
        for (int samples = step.samples; samples <= end; samples *= 2)
            all.push_back({samples, step.error_sum * std::pow(ratio(samples, step.samples), power)});
    }
    tile.steps = std::move(all);
}

}  // namespace

std::vector<Tile> pilot_tiles(int width, int height) {
    const std::vector<Tile> all = tiles_of(width, height);
    const auto part = static_cast<std::size_t>(kPilotPart * static_cast<double>(all.size()));
    const std::size_t wanted = std::max(part, kLeastTiles);
    if (2 * wanted >= all.size()) return all;
    const auto columns = static_cast<std::size_t>((width + kTileSide - 1) / kTileSide);
    const auto rows = all.size() / columns;
    std::set<std::size_t> chosen;
    for (std::uint32_t i = 0; chosen.size() < wanted; ++i) {
        const double u = reverse_bits(i) * 0x1p-32, v = reverse_bits(sobol_y_reversed(i)) * 0x1p-32;
        chosen.insert(static_cast<std::size_t>(v * static_cast<double>(rows)) * columns +
                      static_cast<std::size_t>(u * static_cast<double>(columns)));
    }
    std::vector<Tile> tiles;
    for (const std::size_t number : chosen) tiles.push_back(all[number]);
    return tiles;
}

RaySpread spread_for_mean_error(double mean_error, std::size_t tiles, int first, int most,
                                const TraceTileTo& trace_to) {
    std::vector<TileConvergence> convergences(tiles);
    const auto error_of_all_at = [&](int samples) {
        parallel_for(tiles, [&](std::size_t i) { convergences[i] = trace_to(i, samples); });
        return outcome_of(convergences, {samples, std::numeric_limits<double>::infinity()}).mean_error;
    };
    // Until a doubling of all is enough, in steps that most tiles will take as well.
    std::vector<int> counts{first};
    for (double error = error_of_all_at(first); counts.back() < most;) {
        const double wanted = counts.back() * std::pow(error / mean_error, -1 / kErrorPower);
        int next = counts.back();
        while (2 * next <= wanted && next < most) next *= 2;
        if (next == counts.back()) break;
        counts.push_back(next);
        error = error_of_all_at(next);
    }
    for (TileConvergence& tile : convergences) fill_gaps(tile, most);
    RaySpread soonest{.first = first, .least_gain = highest_gain(convergences, first, mean_error)};
    double least_time = outcome_of(convergences, soonest).time;
    for (int begin = 2 * first; begin <= counts.back(); begin *= 2) {
        // More than that many rays for all would leave less than the error asked for.
        if (outcome_of(convergences, {begin, std::numeric_limits<double>::infinity()}).mean_error <
            mean_error)
            break;
        const RaySpread spread{.first = begin, .least_gain = highest_gain(convergences, begin, mean_error)};
        const double time = outcome_of(convergences, spread).time;
        if (time >= least_time) continue;
        soonest = spread;
        least_time = time;
    }
    return soonest;
}

}  // namespace aoscore
