#include "reference/benchmark/benchmark.h"

#include "core/machine.h"
#include "core/threads.h"
#include "reference/benchmark/growth.h"
#include "reference/benchmark/plain_monte_carlo.h"
#include "reference/benchmark/processor_time.h"
#include "reference/benchmark/random_tiles.h"
#include "reference/benchmark/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

constexpr int kSlopeWidth = 64, kSlopeHeight = 36;
constexpr int kSlopeSeeds = 4;
/// Groups of tiles that speak for the picture, and rays a pixel that speak for the truth.
constexpr std::size_t kPilotGroups = 80;
constexpr int kCheckSamples = 4096;

std::size_t surfaces(const Truth& truth) {
    return static_cast<std::size_t>(std::ranges::count(truth.hits.surface.pixels, 1));
}

TruthSettings with_samples(int samples) {
    TruthSettings settings;
    settings.samples = samples;
    return settings;
}

std::vector<TruthQuery> binary(double radius_m) {
    return {{Falloff::binary, radius_m, 0}};
}

/// Stated errors against a truth of many more rays.
void print_check(const RandomTiles& tiles, const std::vector<TruthQuery>& query,
                 const TruthSettings& settings) {
    const Truth truth = tiles.trace(query, settings);
    TruthSettings many = with_samples(kCheckSamples);
    many.seed = settings.seed + 1;
    const Truth exact = tiles.trace(query, many);
    double squared = 0, stated = 0, pixels = 0;
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        squared += std::pow(truth.visibility[0].pixels[i] - exact.visibility[0].pixels[i], 2);
        stated += std::pow(truth.standard_error[0].pixels[i], 2);
        pixels += truth.hits.surface.pixels[i];
    }
    fmt::print(
        "            checked against {} samples on {:.1f} % of the picture: true root-mean-square error "
        "{:.5f}, "
        "stated {:.5f}\n",
        kCheckSamples, 100 * tiles.part(), std::sqrt(squared / pixels), std::sqrt(stated / pixels));
}

/// A truth and how long it takes.
struct TimedTruth {
    Truth truth;
    double seconds = 0;
    bool whole = true;  ///< else of the random tiles, and the time is scaled up
};

TimedTruth timed_truth(const ReferenceScene& reference, const CameraFrame& frame, const RandomTiles& tiles,
                       const std::vector<TruthQuery>& query, const TruthSettings& settings,
                       double longest_s) {
    TimedTruth timed;
    timed.seconds = seconds_of([&] { timed.truth = tiles.trace(query, settings); }) / tiles.part();
    timed.whole = timed.seconds <= longest_s;
    if (timed.whole)
        timed.seconds = seconds_of([&] { timed.truth = reference.trace(frame, query, settings, "truth"); });
    return timed;
}

/// The least power of two of rays, the same for all pixels, of which the random tiles reach the mean standard
/// error: nets are at their best there.
TruthSettings even_settings(const RandomTiles& tiles, const std::vector<TruthQuery>& query, double target) {
    TruthSettings settings = with_samples(16);
    while (settings.samples < kMostSamples && mean_standard_error(tiles.trace(query, settings)) > target)
        settings.samples *= 2;
    return settings;
}

TruthSettings mean_settings(double target) {
    TruthSettings settings;
    settings.mean_error = target;
    return settings;
}

void print_time_to_error(const ReferenceScene& reference, const EmbreeScene& embree, const CameraFrame& frame,
                         const ReferenceBenchmark& benchmark, double radius_m, RatioTable& table) {
    const RandomTiles tiles(reference, frame, kPilotGroups);
    const std::vector<TruthQuery> query = binary(radius_m);
    const double target = benchmark.target_error;
    const std::vector<Tile> some =
        random_tiles(frame.width(), frame.height(), static_cast<std::size_t>(benchmark.tiles));
    for (const auto& [name, settings] : {std::pair{"the same for all", even_settings(tiles, query, target)},
                                         std::pair{"--mean-error", mean_settings(target)}}) {
        const double rate = plain_rate(embree, frame, radius_m, benchmark.samples, some);
        const auto [truth, seconds, whole] =
            timed_truth(reference, frame, tiles, query, settings, benchmark.longest_s);
        const PlainMonteCarlo plain(truth);
        const double pixels = static_cast<double>(surfaces(truth)) / (whole ? 1 : tiles.part());
        const auto plain_text = [&, s = seconds](double count) {
            const double all = count * pixels / (rate * 1e6);
            return fmt::format("{:.0f} samples, {:.0f} s, {:.1f} times as long", count, all, all / s);
        };
        // To the error that was reached, be it a little above or below the target.
        const double error = mean_standard_error(truth);
        const double best = plain.best_samples_for(error);
        const std::string what = fmt::format("to a mean error of {:.2g}, R {} m, {}", error, radius_m, name);
        table.add("plain Monte Carlo " + what, plain.samples_for(error) * pixels / (rate * 1e6), "s");
        table.add("the tracer " + what, seconds, "s", "plain Monte Carlo " + what);
        fmt::print(
            "R {:>6} m, {}: {:.1f} s{} to a mean standard error of {:.5f}, {} samples in the mean ({:.1f} % "
            "of "
            "pixels proven open)\n",
            radius_m, name, seconds, whole ? "" : " (scaled up from random tiles)", error, truth.samples,
            100.0 * static_cast<double>(truth.open_pixels) / static_cast<double>(surfaces(truth)));
        fmt::print(
            "            plain Monte Carlo by rtcOccluded1, {:.1f} M rays/s: {}; with the best allocation "
            "over "
            "pixels: {}\n",
            rate, plain_text(plain.samples_for(error)), plain_text(best));
        if (best < 1)
            fmt::print(
                "            all pixels are open or blocked: only the least stated error is compared\n");
        print_check(tiles, query, settings);
        std::fflush(stdout);
    }
    TruthSettings adaptive = with_samples(16);
    adaptive.max_error = target;
    const TimedTruth every = timed_truth(reference, frame, tiles, query, adaptive, 0);
    fmt::print(
        "R {:>6} m, every pixel to {}: {:.0f} s (scaled up from {:.1f} % of the picture), {} samples in the "
        "mean, "
        "mean standard error {:.5f}\n",
        radius_m, target, every.seconds, 100 * tiles.part(), every.truth.samples,
        mean_standard_error(every.truth));
}

double mean_square_error(const ReferenceScene& reference, const CameraFrame& frame, double radius_m,
                         int samples, PointKind kind) {
    std::vector<Truth> truths;
    for (int seed = 1; seed <= kSlopeSeeds; ++seed) {
        TruthSettings settings = with_samples(samples);
        settings.seed = static_cast<std::uint64_t>(seed);
        settings.points = kind;
        truths.push_back(reference.trace(frame, binary(radius_m), settings, "slope"));
    }
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < truths[0].hits.surface.size(); ++i) {
        if (truths[0].hits.surface.pixels[i] == 0) continue;
        double mean = 0;
        for (const Truth& t : truths) mean += t.visibility[0].pixels[i] / kSlopeSeeds;
        for (const Truth& t : truths)
            sum += std::pow(t.visibility[0].pixels[i] - mean, 2) / (kSlopeSeeds - 1);
        ++pixels;
    }
    return sum / pixels;
}

void print_slopes(const ReferenceScene& reference, const Camera& camera, double radius_m) {
    const CameraFrame frame(camera, kSlopeWidth, kSlopeHeight);
    for (const auto& [kind, name] : {std::pair{PointKind::scrambled_sobol, "scrambled Sobol"},
                                     std::pair{PointKind::independent, "independent    "}}) {
        fmt::print("R {:>6} m, {}:", radius_m, name);
        double first = 0, last = 0;
        for (int samples = 16; samples <= 4096; samples *= 4) {
            last = std::sqrt(mean_square_error(reference, frame, radius_m, samples, kind));
            if (samples == 16) first = last;
            fmt::print(" {:.5f}", last);
        }
        if (first > 0 && last > 0)
            fmt::print("  slope {:.2f}\n", std::log(last / first) / std::log(4096.0 / 16));
        else
            fmt::print("  no error left to fall\n");
    }
}

void add_rates(const ReplayRates& rates, const std::string& what, RatioTable& table) {
    const std::string packets = "bare Embree, the tracer's packets, " + what;
    table.add(packets, rates.packets, "million rays/s");
    table.add("bare Embree, best plain order, " + what, rates.best_plain(), "million rays/s", packets);
    table.add("traced, " + what, rates.traced, "million rays/s", packets);
}

void print_rates(const EmbreeScene& embree, const CameraFrame& frame, const ReferenceBenchmark& benchmark,
                 RatioTable& table) {
    fmt::print("Million rays a second, {} rays a pixel, {} random tiles:\n", benchmark.samples,
               benchmark.tiles);
    for (const RayQuestion question : {RayQuestion::occlusion, RayQuestion::distance}) {
        for (const double radius_m : benchmark.radii_m) {
            const ReplayRates rates =
                replay_rates(embree, frame, radius_m, question, benchmark.samples, benchmark.tiles);
            add_rates(rates,
                      fmt::format("{}, R {} m", question == RayQuestion::occlusion ? "occlusion" : "distance",
                                  radius_m),
                      table);
            fmt::print(
                "R {:>6} m, {}: traced {:.1f} | replays: one by one {:.1f}, 16 of a pixel {:.1f}, 16 of a "
                "block "
                "{:.1f}; traced / best of them {:.3f} | the very packets of the tracer {:.1f}; traced / that "
                "{:.3f}\n",
                radius_m, question == RayQuestion::occlusion ? "occlusion" : "distance ", rates.traced,
                rates.single, rates.pixel, rates.block, rates.traced / rates.best_plain(), rates.packets,
                rates.traced / rates.packets);
            std::fflush(stdout);
        }
    }
}

}  // namespace

void reference_benchmark(const Scene& scene, const View& view, const ReferenceBenchmark& benchmark,
                         RatioTable& table) {
    std::optional<ReferenceScene> built;
    const double build_s = seconds_of([&] { built.emplace(scene); });
    const ReferenceScene& reference = *built;
    fmt::print("{}/{}: {} triangles, {}x{}, {} threads; built in {:.2f} s, {} MB in Embree\n", scene.id,
               view.id, scene.triangle_count, benchmark.width, benchmark.height, thread_count(), build_s,
               reference.peak_bytes() / 1'000'000);
    fmt::print("Root-mean-square error at 16, 64, 256, 1024, 4096 samples:\n");
    for (const double radius_m : benchmark.radii_m) print_slopes(reference, view.camera, radius_m);
    const EmbreeScene embree(scene, {});
    const CameraFrame frame(view.camera, benchmark.width, benchmark.height);
    print_rates(embree, frame, benchmark, table);
    fmt::print("Time to the error:\n");
    for (const double radius_m : benchmark.radii_m) {
        print_time_to_error(reference, embree, frame, benchmark, radius_m, table);
        std::fflush(stdout);
    }
    fmt::print("Peak memory of the whole process so far: {:.0f} MiB\n", peak_memory_mib());
    if (benchmark.growth) print_growth(scene, reference, view.camera, benchmark);
}

}  // namespace aoscore
