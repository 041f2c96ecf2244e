#include "reference/sampling/pilot.h"

#include "core/error.h"
#include "core/rough_text.h"
#include "reference/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace aoscore {
namespace {

/// Tiles that find roughly how many rays it will be.
constexpr std::size_t kFirstTiles = 64;
/// How well the mean of all tiles is to be known by some, as a part of it, and how many tiles are traced for
/// that at most.
constexpr double kWantedPart = 0.007;
constexpr std::size_t kMostTiles = 2048;
constexpr std::size_t kMostOfPicture = 4;  ///< or, where these are more, one in so many
/// Stated errors fall by so much as rays are doubled, see TileLaw, where it has not been measured.
const double kUsualPower = -std::log2(std::sqrt(0.373));
/// As they fall at worst and at best: what lies outside is chance.
constexpr double kFlattest = 0.4, kSteepest = 1;
/// From so many rays on pixels are proven open first, and what errors there are is less by a leap.
constexpr int kProofsFrom = 64;
/// With so many rays the first tiles tell how long it will take, but for a small factor.
constexpr int kSamplesToTell = 1024;
/// A first try is a little too low, since tiles go on from fewer rays, but not from more.
constexpr double kFirstTry = 0.75;
constexpr int kTries = 5, kStepsOfOctave = 32;
/// How far below what was asked for a try may end, and how far above it.
constexpr double kBelow = 0.03, kAbove = 0.02;
/// What is called in reach by a few tiles is so by all.
constexpr double kRoughly = 1.1;
constexpr double kDay_s = 86400;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A mean error over all pixels of some tiles.
struct MeanError {
    double value = 0;
    double variance_of_tile = 0;  ///< relative, such that that of the mean is so much over the tiles
};

MeanError mean_of(const std::vector<TileErrors>& tiles, std::size_t query) {
    double errors = 0, surfaces = 0;
    for (const TileErrors& tile : tiles) {
        if (!tile.error_sums.empty()) errors += tile.error_sums[query];
        surfaces += static_cast<double>(tile.surfaces);
    }
    if (surfaces == 0 || errors == 0) return {};
    const double mean = errors / surfaces;
    double squares = 0;
    for (const TileErrors& tile : tiles) {
        const double sum = tile.error_sums.empty() ? 0 : tile.error_sums[query];
        squares += std::pow(sum - mean * static_cast<double>(tile.surfaces), 2);
    }
    const auto count = static_cast<double>(tiles.size());
    return {mean, count * squares / (errors * errors)};
}

MeanError largest_mean_of(const std::vector<TileErrors>& tiles) {
    MeanError largest;
    std::size_t queries = 0;
    for (const TileErrors& tile : tiles) queries = std::max(queries, tile.error_sums.size());
    for (std::size_t query = 0; query < queries; ++query) {
        const MeanError mean = mean_of(tiles, query);
        if (mean.value > largest.value) largest = mean;
    }
    return largest;
}

/// The count nearest to this that is a whole number of steps of its octave.
int rounded(double samples) {
    const double step = std::max(1.0, std::exp2(std::floor(std::log2(samples))) / kStepsOfOctave);
    return static_cast<int>(std::round(samples / step) * step);
}

/// Looks for the rays of one picture.
class Search {
  public:
    Search(double mean_error, std::size_t tiles, int first, const TracePilot& trace, const TellRays& tell)
        : mean_error_(mean_error), first_(first), all_(tiles), trace_(trace), tell_(tell) {}

    EvenRays run() {
        find_roughly();
        tell();
        const int samples = find_closely();
        return {samples, seconds_of(samples)};
    }

  private:
    void tell() {
        if (!told_ && tell_) tell_({static_cast<int>(wanted()), seconds_of(wanted())});
        told_ = true;
    }

    /// Rays that the error asked for takes, as far as the last measurement tells.
    double wanted() const { return std::max<double>(first_, samples_ * std::pow(ratio(), 1 / power_)); }
    /// Of the last measurement to what is asked for.
    double ratio() const { return std::max(error_.value / mean_error_, 1e-9); }

    void measure(int samples) {
        const auto start = std::chrono::steady_clock::now();
        error_ = largest_mean_of(trace_(tiles_, samples));
        samples_ = samples;
        const double rays = static_cast<double>(tiles_) * samples;
        if (rays <= traced_) return;  // What was there was no use: that says nothing of time.
        seconds_per_ray_ = seconds_since(start) / (rays - traced_);
        traced_ = rays;
    }

    /// A few tiles, with more and more rays.
    void find_roughly() {
        tiles_ = std::min(all_, kFirstTiles);
        measure(first_);
        while (wanted() >= 2 * samples_) {
            require_in_reach();
            if (samples_ >= kSamplesToTell) tell();
            const double error = error_.value, before = samples_;
            const int leap = before < kProofsFrom ? std::max<int>(2 * samples_, kProofsFrom) : 4 * samples_;
            const int octave = 1 << static_cast<int>(std::log2(std::min<double>(wanted(), kMostSamples)));
            measure(std::min(octave, leap));
            const bool leapt = before < kProofsFrom && samples_ >= kProofsFrom;
            if (!leapt && error > 0 && error_.value > 0)
                power_ = std::clamp(std::log(error / error_.value) / std::log(samples_ / before), kFlattest,
                                    kSteepest);
        }
        require_in_reach();
    }

    /// As many tiles as it takes, with what seems right, until it is.
    int find_closely() {
        std::map<int, double> ratios;  // by rays
        int next = std::max(first_, rounded(kFirstTry * wanted()));
        for (int i = 0; i < kTries && !ratios.contains(next); ++i) {
            tiles_ = std::max(tiles_, tiles_for_precision());
            measure(next);
            ratios[next] = ratio();
            if (ratio() > 1 - kBelow && ratio() < 1 + kAbove && tiles_ >= tiles_for_precision()) return next;
            require_in_reach();
            const int step = std::max(1, (next - 1) / (2 * kStepsOfOctave));
            const bool more = ratio() > 1;
            next = more ? std::max(rounded(wanted()), samples_ + step) : rounded(wanted());
            if (samples_ < kProofsFrom && next > kProofsFrom) next = kProofsFrom;
        }
        const auto distance = [](const auto& tried) {
            return tried.second < 1 + kAbove ? std::abs(tried.second - 1) : 1 + tried.second;
        };
        return std::ranges::min_element(ratios, {}, distance)->first;
    }

    /// Of a finite number, the fewer are left the less they are in doubt.
    std::size_t tiles_for_precision() const {
        const double of_many = error_.variance_of_tile / (kWantedPart * kWantedPart);
        const double count = of_many / (1 + of_many / static_cast<double>(all_));
        const std::size_t most = std::min(all_, std::max(kMostTiles, all_ / kMostOfPicture));
        return std::min(static_cast<std::size_t>(std::ceil(count)), most);
    }

    double seconds_of(double samples) const { return seconds_per_ray_ * samples * static_cast<double>(all_); }

    void require_in_reach() const {
        const double rays = wanted(), seconds = seconds_of(rays);
        if (rays <= kMostSamples && seconds <= kDay_s) return;
        const double most = std::min<double>(kMostSamples, rays * kDay_s / seconds);
        throw usage_error(fmt::format("a mean error of {:g} takes about {} rays a pixel and {}", mean_error_,
                                      rough_number(rays), rough_duration(seconds)),
                          "mean error",
                          fmt::format("{:.2g} or more on this view",
                                      kRoughly * mean_error_ * std::pow(rays / most, power_)));
    }

    double mean_error_;
    int first_;
    std::size_t all_;
    const TracePilot& trace_;
    const TellRays& tell_;
    bool told_ = false;
    std::size_t tiles_ = 0;       ///< of the next measurement
    int samples_ = 0;             ///< of the last one
    MeanError error_;             ///< its outcome
    double power_ = kUsualPower;  ///< of the rays, by which the error falls
    double seconds_per_ray_ = 0;  ///< a ray for each pixel of a tile
    double traced_ = 0;           ///< rays so far, likewise
};

}  // namespace

EvenRays rays_for_mean_error(double mean_error, std::size_t tiles, int first, const TracePilot& trace,
                             const TellRays& tell) {
    return Search(mean_error, tiles, first, trace, tell).run();
}

}  // namespace aoscore
