#include "reference/integrator/error_forecast.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/rough_text.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/tile_integrator.h"
#include "reference/sampling/point_sets.h"
#include "reference/sampling/sample_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace aoscore {
namespace {

constexpr std::size_t kTiles = 64;
/// Rays that pixels get at most, and by how many times fewer the fall of their errors is measured.
constexpr int kMostRays = 512, kFewer = 8;
/// Of 100 pixels so many may take more rays than a pixel can have.
constexpr double kMayStopShort = 0.01;

/// Traces tiles with the same number of rays for all, going on from fewer.
class FewTiles {
  public:
    FewTiles(const ReachableScene& scene, const CameraFrame& frame, const std::vector<TruthQuery>& queries,
             const TruthSettings& settings, const CauseJudge& judge)
        : scene_(scene),
          frame_(frame),
          queries_(queries),
          settings_(settings),
          judge_(judge),
          tiles_(spread_tiles(frame.width(), frame.height())) {
        all_ = tiles_.size();
        tiles_.resize(std::min(all_, kTiles));
        states_.resize(tiles_.size());
    }

    void trace(int samples) {
        TruthSettings even = settings_;
        even.samples = samples;
        even.max_error = 0;
        even.extras = {};
        const PointSets points(even.points, samples);
        std::atomic<double> seconds{0};
        std::atomic<std::uint64_t> rays{0};
        parallel_for(tiles_.size(), [&](std::size_t i) {
            throw_if_interrupted();
            const FlushDenormals flush;
            const Stopwatch watch;
            TileIntegrator integrator(scene_, frame_, queries_, even, points, judge_);
            states_[i] = integrator.trace(tiles_[i].tile, &states_[i]);
            rays += integrator.rays();
            seconds += watch.seconds();
        });
        if (rays > 0) seconds_per_ray_ = seconds / static_cast<double>(rays) / thread_count();
    }

    /// The largest of each pixel that got rays, over the queries.
    std::vector<double> errors() const {
        std::vector<double> all;
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            const auto by_query = stated_errors(tiles_[i].tile, states_[i], queries_, settings_);
            std::vector<double> largest = by_query.front();
            for (const std::vector<double>& errors : by_query)
                std::ranges::transform(largest, errors, largest.begin(),
                                       [](double a, double b) { return std::max(a, b); });
            all.insert(all.end(), largest.begin(), largest.end());
        }
        return all;
    }

    double seconds_per_ray() const { return seconds_per_ray_; }
    double pixels() const {
        double count = 0;
        for (const TileState& state : states_) count += static_cast<double>(state.surfaces());
        return count;
    }
    /// Tiles of the picture for each of these.
    double times() const { return static_cast<double>(all_) / static_cast<double>(tiles_.size()); }

  private:
    const ReachableScene& scene_;
    const CameraFrame& frame_;
    const std::vector<TruthQuery>& queries_;
    const TruthSettings& settings_;
    const CauseJudge& judge_;
    std::vector<SpreadTile> tiles_;
    std::size_t all_ = 0;
    std::vector<TileState> states_;
    double seconds_per_ray_ = 0;
};

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

}  // namespace

ErrorForecast forecast_error(const ReachableScene& scene, const CameraFrame& frame,
                             const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                             const CauseJudge& judge) {
    const int first = SamplePlan(settings).first();
    const int samples = std::min(first, kMostRays), fewer = std::max(1, samples / kFewer);
    FewTiles tiles(scene, frame, queries, settings, judge);
    tiles.trace(fewer);
    const double before = sum_of(tiles.errors());
    tiles.trace(samples);
    std::vector<double> errors = tiles.errors();
    ErrorForecast forecast;
    if (errors.empty()) return forecast;
    forecast.power = std::clamp(std::log(before / sum_of(errors)) / std::log(double(samples) / fewer),
                                kFlattestFall, kSteepestFall);
    std::vector<double> rays;
    for (const double error : errors) {
        const double wanted = samples * std::pow(error / settings.max_error, 1 / forecast.power);
        rays.push_back(std::max<double>(first, wanted));
    }
    std::ranges::sort(rays);
    const auto rank = static_cast<std::size_t>((1 - kMayStopShort) * static_cast<double>(rays.size()));
    forecast.most_rays = rays[std::min(rank, rays.size() - 1)];
    forecast.rays_a_pixel = sum_of(rays) / tiles.pixels();
    forecast.seconds = sum_of(rays) * tiles.times() * tiles.seconds_per_ray();
    return forecast;
}

void require_in_reach(const ErrorForecast& forecast, double max_error) {
    const double excess = std::max(forecast.most_rays / kMostSamples, forecast.seconds / kLongestTrace_s);
    if (excess <= 1) return;
    throw usage_error(
        fmt::format("an error of {:g} in every pixel takes about {} rays a pixel, {} in some, and {}",
                    max_error, rough_number(forecast.rays_a_pixel), rough_number(forecast.most_rays),
                    rough_duration(forecast.seconds)),
        "--error",
        fmt::format("{:.2g} or more on this view",
                    kReachMargin * max_error * std::pow(excess, forecast.power)));
}

std::string forecast_text(const ErrorForecast& forecast, double max_error) {
    return fmt::format("an error of {:g} in every pixel takes roughly {} rays a pixel and {}", max_error,
                       rough_number(forecast.rays_a_pixel), rough_duration(forecast.seconds));
}

}  // namespace aoscore
