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

/// Prices at which a tile leaves its rungs, highest first.
double price_of(const Rung& rung, const Ladder& ladder) {
    return rung.error_sum / static_cast<double>(ladder.traced) / rung.samples;
}

/// Of the rung that a tile stops at.
double error_sum_at(const Ladder& ladder, double price) {
    for (const Rung& rung : ladder.rungs) {
        if (price_of(rung, ladder) <= price) return rung.error_sum;
    }
    return ladder.rungs.empty() ? 0 : ladder.rungs.back().error_sum;
}

double mean_error_at(const std::vector<Ladder>& ladders, double price) {
    double sum = 0, surfaces = 0;
    for (const Ladder& ladder : ladders) {
        sum += error_sum_at(ladder, price);
        surfaces += static_cast<double>(ladder.surfaces);
    }
    return surfaces > 0 ? sum / surfaces : 0;
}

/// The highest price, among those at which some tile stops earlier, that is low enough.
double highest_price(const std::vector<Ladder>& ladders, double mean_error) {
    std::vector<double> prices;
    for (const Ladder& ladder : ladders) {
        for (const Rung& rung : ladder.rungs) prices.push_back(price_of(rung, ladder));
    }
    std::sort(prices.begin(), prices.end());
    const auto too_high = std::partition_point(prices.begin(), prices.end(), [&](double price) {
        return mean_error_at(ladders, price) <= mean_error;
    });
    return too_high == prices.begin() ? 0 : *(too_high - 1);
}

}  // namespace

double price_for_mean_error(double mean_error, int width, int height, const Climb& climb) {
    const auto part =
        static_cast<std::size_t>(kPilotPart * static_cast<double>(tiles_of(width, height).size()));
    const std::vector<Tile> tiles = random_tiles(width, height, std::max(part, kLeastTiles));
    std::vector<Ladder> ladders(tiles.size());
    const auto climb_all = [&](double price) {
        parallel_for(tiles.size(), [&](std::size_t i) { ladders[i] = climb(tiles[i], price); });
        return mean_error_at(ladders, price);
    };
    double price = std::numeric_limits<double>::infinity();
    const double first_error = climb_all(price);
    if (first_error <= mean_error) return price;
    int first = 0;
    for (const Ladder& ladder : ladders) {
        if (!ladder.rungs.empty()) first = ladder.rungs.front().samples;
    }
    // By the law of the error, and a little lower, so that the price lies within what is climbed.
    price = mean_error / (first * std::pow(first_error / mean_error, kSamplesPerError)) / 2;
    for (int round = 0; climb_all(price) > mean_error; ++round) {
        constexpr int kMostRounds = 24;  // a tile that has all the rays there are errs as it does
        if (round == kMostRounds) return price;
        price /= 2;
    }
    return highest_price(ladders, mean_error);
}

}  // namespace aoscore
