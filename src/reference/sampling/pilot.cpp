#include "reference/sampling/pilot.h"

#include "core/error.h"
#include "core/rough_text.h"
#include "reference/estimate/pixel_spread.h"
#include "reference/estimate/variance_fall.h"
#include "reference/sampling/sample_plan.h"
#include "reference/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace aoscore {
namespace {

/// Tiles that find roughly how many rays it will be, and how the error falls.
constexpr std::size_t kFewTiles = 64;
/// How well the mean of all tiles is to be known by many of them, as a part of it, and how many are traced
/// for that at most: as many, and where these are more, one in so many.
constexpr double kWantedPart = 0.012;
constexpr std::size_t kMostTiles = 2048, kMostOfPicture = 4;
/// With more tiles, what tells a tile from the next one falls by this power of their number: 64 to 1,800
/// tiles of six scenes at 640x360.
constexpr double kAlike = 0.35;
/// Variances fall by so much as rays are doubled, see TileLaw, and errors by this power of the rays, where it
/// has not been measured.
constexpr double kUsualRatio = 0.373;
const double kUsualPower = -std::log2(std::sqrt(kUsualRatio));
/// From so many rays on pixels are proven open first, and what errors there are is less by a leap.
constexpr int kProofsFrom = 64;
/// With so many rays the few tiles tell how long it will take, but for a small factor.
constexpr int kSamplesToTell = 1024;
/// The many get this part of what the few ask for, since tiles go on from fewer rays, but not from more; or
/// as many as the few have where these are between this part and that.
constexpr double kFirstTry = 0.75, kMostToTry = 0.9;
/// How far below what was asked for many tiles may be, and how far above it, to be done; and what is aimed
/// at, since rays that are missing cost less than those that were too many.
constexpr double kBelow = 0.03, kAbove = 0.02, kAim = 1.007;
/// Rays that are there are not given up for fewer unless the error is so far below what was asked for.
constexpr double kFarBelow = 0.04;
/// How near to it few tiles must come to tell the rest without being tried again. They try this part of what
/// seems right, where that is so many times what was tried before: they, too, go on from fewer rays alone.
constexpr double kNear = 0.03, kJustBelow = 0.95, kFar = 1.12;
constexpr int kTries = 5;
/// How far counts are looked at about the one that a power tells, and in how many steps of it.
constexpr double kStepOut = 1.3;
constexpr int kSteps = 256;
/// Standard deviations by which the few must be below to speak for all.
constexpr double kSurely = 4;

/// A mean error over all pixels of some tiles.
struct MeanError {
    double value = 0;
    double variance_of_tile = 0;  ///< relative, such that that of the mean is so much over the tiles
};

MeanError mean_of(std::span<const TileErrors> tiles, std::size_t query) {
    double errors = 0, surfaces = 0;
    for (const TileErrors& tile : tiles) {
        if (!tile.error_sums.empty()) errors += tile.error_sums[query];
        surfaces += static_cast<double>(tile.surfaces);
    }
    if (surfaces == 0 || errors == 0) return {};
    const double mean = errors / surfaces;
    // Tiles that are spread evenly miss the mean by what tells them from their neighbours alone.
    std::vector<std::pair<std::size_t, double>> excess;
    excess.reserve(tiles.size());
    for (const TileErrors& tile : tiles) {
        const double sum = tile.error_sums.empty() ? 0 : tile.error_sums[query];
        excess.emplace_back(tile.place, sum - mean * static_cast<double>(tile.surfaces));
    }
    std::ranges::sort(excess);
    double squares = 0;
    for (std::size_t i = 1; i < excess.size(); ++i)
        squares += std::pow(excess[i].second - excess[i - 1].second, 2) / 2;
    const auto count = static_cast<double>(tiles.size());
    return {mean, count * squares / (errors * errors)};
}

MeanError largest_mean_of(std::span<const TileErrors> tiles) {
    MeanError largest;
    std::size_t queries = 0;
    for (const TileErrors& tile : tiles) queries = std::max(queries, tile.error_sums.size());
    for (std::size_t query = 0; query < queries; ++query) {
        const MeanError mean = mean_of(tiles, query);
        if (mean.value > largest.value) largest = mean;
    }
    return largest;
}

/// What a pixel of so many rays errs by, up to a factor: a part of a block beyond the last whole one helps
/// little, so that this falls in steps.
double usual_error(int samples) {
    return std::sqrt(variance_after_falls(kUsualRatio, block_size(samples)) *
                     pooled_variance(samples, kUsualRatio));
}

/// Looks for the rays of one picture.
class Search {
  public:
    Search(double mean_error, std::size_t tiles, int first, const TracePilot& trace, const TellRays& tell)
        : mean_error_(mean_error), first_(first), all_(tiles), trace_(trace), tell_(tell) {}

    EvenRays run() {
        find_roughly();
        tell();
        const int samples = surely_enough() ? first_ : find_closely();
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

    void measure(std::size_t tiles, int samples) {
        const PilotMeasure measured = trace_(tiles, samples);
        error_ = largest_mean_of(measured.tiles);
        few_error_ = largest_mean_of(std::span(measured.tiles).first(few_)).value;
        samples_ = samples;
        const auto few = static_cast<double>(few_);
        const double goes_on_from = samples > few_samples_ ? few * few_samples_ : 0;
        const double rays = static_cast<double>(tiles) * samples - goes_on_from;
        few_samples_ = samples;
        if (rays > 0 && measured.seconds > 0) seconds_per_ray_ = measured.seconds / rays;
    }

    /// A few tiles, with more and more rays.
    void find_roughly() {
        measure(few_, first_);
        while (wanted() >= 2 * samples_) {
            require_in_reach();
            if (samples_ >= kSamplesToTell) tell();
            const double error = error_.value, before = samples_;
            const int leap = before < kProofsFrom ? std::max<int>(2 * samples_, kProofsFrom) : 4 * samples_;
            const int octave = 1 << static_cast<int>(std::log2(std::min<double>(wanted(), kMostSamples)));
            measure(few_, std::min(octave, leap));
            if (before >= kProofsFrom || samples_ < kProofsFrom)
                learn_power(before, error, samples_, error_.value);
        }
        require_in_reach();
    }

    void learn_power(double samples, double error, double more, double less_error) {
        if (error <= 0 || less_error <= 0) return;
        // Less than an octave is seen through its steps.
        const double usual = usual_error(static_cast<int>(samples)) / usual_error(static_cast<int>(more));
        const double octaves = more < 2 * samples ? std::log(usual) / kUsualPower : std::log(more / samples);
        power_ = std::clamp(std::log(error / less_error) / octaves, kFlattestFall, kSteepestFall);
    }

    /// Whether the rays that every pixel has at least are more than enough.
    bool surely_enough() const {
        const double doubt = doubt_of(few_);
        return samples_ == first_ && ratio() * (1 + kSurely * doubt) < 1;
    }

    /// As many tiles as it takes, with a little less than what seems right; the few, until they are near
    /// enough to tell the rest; and the many again.
    int find_closely() {
        const std::size_t many = tiles_for_precision();
        measure(many, samples_to_begin());
        require_in_reach();
        if (is_enough(ratio()) || (ratio() < 1 && samples_ == first_)) return samples_;
        const int begun = samples_;
        const double begun_ratio = ratio();
        const int best = find_with_few();
        if (best <= begun) return best;
        measure(many, best);
        if (is_enough(ratio())) return best;
        if (ratio() > 1) return best_after(best, ratio());
        const bool leaps = begun < kProofsFrom && best >= kProofsFrom;
        if (leaps || ratio() > 1 - kFarBelow) return best;
        const double part = std::log(begun_ratio) / std::log(begun_ratio / ratio());
        return std::clamp(static_cast<int>(std::ceil(begun * std::pow(double(best) / begun, part))), begun,
                          best);
    }

    static bool is_enough(double ratio) { return ratio > 1 - kBelow && ratio < 1 + kAbove; }

    int find_with_few() {
        const double many_ratio = ratio(), few_begun = few_error_;
        std::map<int, double> ratios{{samples_, many_ratio}};
        for (int i = 0; i < kTries; ++i) {
            const int from = nearest(ratios), best = best_after(from, ratios.at(from));
            if (std::abs(ratios.at(from) - 1) < kNear || ratios.contains(best)) return best;
            const int next = best < kFar * from ? best : static_cast<int>(kJustBelow * best);
            const double before = samples_, error = few_error_;
            measure(few_, next);
            require_in_reach();
            if (before >= kProofsFrom || next < kProofsFrom) learn_power(before, error, next, few_error_);
            ratios[next] = few_begun > 0 ? many_ratio * few_error_ / few_begun : many_ratio;
        }
        return nearest(ratios);
    }

    int samples_to_begin() const {
        const double rays = wanted();
        if (samples_ >= kFirstTry * rays && samples_ <= kMostToTry * rays) return samples_;
        const bool proven = rays >= kProofsFrom;
        return std::max({first_, static_cast<int>(kFirstTry * rays), proven ? kProofsFrom : 1});
    }

    /// The least count that is enough, as far as the outcome of `from` rays tells.
    int best_after(int from, double ratio_there) const {
        const double rays = from * std::pow(std::max(ratio_there, 1e-9), 1 / power_);
        const double most = std::min<double>(kStepOut * rays, kMostSamples);
        const double step = std::max(1.0, std::floor(rays / kSteps));
        double best = std::max<double>(first_, std::round(rays / kStepOut));
        while (best + step <= most &&
               ratio_there * std::pow(usual_error(static_cast<int>(best)) / usual_error(from),
                                      power_ / kUsualPower) >
                   kAim)
            best += step;
        return static_cast<int>(from < kProofsFrom ? std::min<double>(best, std::max(kProofsFrom, from))
                                                   : best);
    }

    static int nearest(const std::map<int, double>& ratios) {
        return std::ranges::min_element(
                   ratios, {},
                   [](const auto& tried) { return std::abs(std::log(std::max(tried.second, 1e-9))); })
            ->first;
    }

    std::size_t tiles_for_precision() const {
        const std::size_t most = std::min(all_, std::max(kMostTiles, all_ / kMostOfPicture));
        std::size_t tiles = few_;
        while (tiles < most && doubt_of(tiles) > kWantedPart) tiles = std::min(most, tiles + tiles / 8 + 1);
        return tiles;
    }

    /// The standard deviation of the mean of so many tiles, as a part of it, by what the few tell.
    double doubt_of(std::size_t tiles) const {
        const auto count = static_cast<double>(tiles), few = static_cast<double>(few_);
        // The closer they lie, the less they tell apart; and the fewer are left, the less there is in doubt.
        const double alike = std::pow(few / count, kAlike);
        const double left = 1 - count / static_cast<double>(all_);
        return std::sqrt(error_.variance_of_tile * alike * left / count);
    }

    double seconds_of(double samples) const { return seconds_per_ray_ * samples * static_cast<double>(all_); }

    void require_in_reach() const {
        const double rays = wanted(), seconds = seconds_of(rays);
        if (rays <= kMostSamples && seconds <= kLongestTrace_s) return;
        const double most = std::min<double>(kMostSamples, rays * kLongestTrace_s / seconds);
        throw usage_error(fmt::format("a mean error of {:g} takes about {} rays a pixel and {}", mean_error_,
                                      rough_number(rays), rough_duration(seconds)),
                          "--mean-error",
                          fmt::format("{:.2g} or more on this view",
                                      kReachMargin * mean_error_ * std::pow(rays / most, power_)));
    }

    double mean_error_;
    int first_;
    std::size_t all_;
    const TracePilot& trace_;
    const TellRays& tell_;
    bool told_ = false;
    std::size_t few_ = std::min(all_, kFewTiles);
    int samples_ = 0;             ///< of the last measurement
    MeanError error_;             ///< its outcome
    double few_error_ = 0;        ///< that of the few tiles among them
    int few_samples_ = 0;         ///< that the few have
    double power_ = kUsualPower;  ///< of the rays, by which the error falls
    double seconds_per_ray_ = 0;  ///< a ray for each pixel of a tile
};

}  // namespace

EvenRays rays_for_mean_error(double mean_error, std::size_t tiles, int first, const TracePilot& trace,
                             const TellRays& tell) {
    return Search(mean_error, tiles, first, trace, tell).run();
}

}  // namespace aoscore
