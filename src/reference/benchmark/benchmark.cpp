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

/// The next count of the form m 2^k with m from 4 to 7.
int next_count(int samples) {
    int step = 1;
    while (samples >= 8 * step) step *= 2;
    return samples + step;
}

/// The least count of which the random tiles reach the mean standard error.
int samples_to_error(const RandomTiles& tiles, const std::vector<TruthQuery>& query, double target) {
    const auto error = [&](int samples) {
        return mean_standard_error(tiles.trace(query, with_samples(samples)));
    };
    // A first guess by the law of the error, a little low.
    constexpr int kFirst = 64;
    const double guess = 0.6 * kFirst * std::pow(error(kFirst) / target, 4.0 / 3);
    int samples = 4;
    while (samples < guess) samples = next_count(samples);
    while (error(samples) > target) samples = next_count(samples);
    return samples;
}

/// Stated errors against a truth of many more rays.
void print_check(const RandomTiles& tiles, const std::vector<TruthQuery>& query, int samples) {
    TruthSettings settings = with_samples(samples);
    const Truth truth = tiles.trace(query, settings);
    settings.samples = kCheckSamples;
    settings.seed = 2;
    const Truth exact = tiles.trace(query, settings);
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

void print_time_to_error(const ReferenceScene& reference, const Camera& camera,
                         const ReferenceBenchmark& benchmark, double radius_m, double single_rate) {
    const CameraFrame frame(camera, benchmark.width, benchmark.height);
    const RandomTiles tiles(reference, frame, kPilotGroups);
    const std::vector<TruthQuery> query = binary(radius_m);
    const int samples = samples_to_error(tiles, query, benchmark.target_error);
    Truth truth;
    double seconds = seconds_of([&] { truth = tiles.trace(query, with_samples(samples)); }) / tiles.part();
    const bool whole = seconds <= benchmark.longest_s;
    if (whole)
        seconds = seconds_of([&] { truth = reference.trace(frame, query, with_samples(samples), "truth"); });
    const PlainMonteCarlo plain(truth);
    const double pixels = static_cast<double>(surfaces(truth)) / (whole ? 1 : tiles.part());
    const auto plain_seconds = [&](double count) { return count * pixels / (single_rate * 1e6); };
    // To the error that was reached, be it a little above or below the target.
    const double error = mean_standard_error(truth);
    const double count = plain.samples_for(error), best = plain.best_samples_for(error);
    fmt::print(
        "R {:>6} m: {} samples, {:.1f} s{} to a mean standard error of {:.5f} ({:.1f} % of pixels proven "
        "open)\n",
        radius_m, samples, seconds, whole ? "" : " (scaled up from random tiles)", error,
        100.0 * static_cast<double>(truth.open_pixels) / static_cast<double>(surfaces(truth)));
    fmt::print(
        "            plain Monte Carlo by rtcOccluded1: {:.0f} samples, {:.0f} s, {:.1f} times as long; with "
        "the "
        "best allocation over pixels {:.0f} samples, {:.1f} times\n",
        count, plain_seconds(count), plain_seconds(count) / seconds, best, plain_seconds(best) / seconds);
    if (best < 1)
        fmt::print("            all pixels are open or blocked: only the stated floor is compared\n");
    print_check(tiles, query, samples);
    TruthSettings adaptive = with_samples(16);
    adaptive.max_error = benchmark.target_error;
    const double adaptive_seconds = seconds_of([&] { truth = tiles.trace(query, adaptive); });
    fmt::print(
        "            every pixel to {}, {:.1f} % of the picture: {} samples in the mean, {:.1f} s, mean "
        "standard "
        "error {:.5f}\n",
        benchmark.target_error, 100 * tiles.part(), truth.samples, adaptive_seconds,
        mean_standard_error(truth));
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

/// Returns what rtcOccluded1 replays, by radius.
std::vector<double> print_rates(const Scene& scene, const Camera& camera,
                                const ReferenceBenchmark& benchmark) {
    const EmbreeScene embree(scene, {});
    const CameraFrame frame(camera, benchmark.width, benchmark.height);
    fmt::print("Million rays a second, {} rays a pixel, {} random tiles:\n", benchmark.samples,
               benchmark.tiles);
    std::vector<double> single_rates;
    for (const RayQuestion question : {RayQuestion::occlusion, RayQuestion::distance}) {
        for (const double radius_m : benchmark.radii_m) {
            const ReplayRates rates =
                replay_rates(embree, frame, radius_m, question, benchmark.samples, benchmark.tiles);
            if (question == RayQuestion::occlusion) single_rates.push_back(rates.single);
            fmt::print(
                "R {:>6} m, {}: traced {:.1f} | replays: one by one {:.1f}, 16 of a pixel {:.1f}, 16 of a "
                "block "
                "{:.1f}; traced / best of them {:.3f} | the very packets of the tracer {:.1f}; traced / that "
                "{:.3f}\n",
                radius_m, question == RayQuestion::occlusion ? "occlusion" : "distance ", rates.traced,
                rates.single, rates.pixel, rates.block, rates.traced / rates.best_plain(), rates.sorted,
                rates.traced / rates.sorted);
            std::fflush(stdout);
        }
    }
    return single_rates;
}

}  // namespace

void reference_benchmark(const Scene& scene, const View& view, const ReferenceBenchmark& benchmark) {
    std::optional<ReferenceScene> built;
    const double build_s = seconds_of([&] { built.emplace(scene); });
    const ReferenceScene& reference = *built;
    fmt::print("{}/{}: {} triangles, {}x{}, {} threads; built in {:.2f} s, {} MB in Embree\n", scene.id,
               view.id, scene.triangle_count, benchmark.width, benchmark.height, thread_count(), build_s,
               reference.peak_bytes() / 1'000'000);
    fmt::print("Root-mean-square error at 16, 64, 256, 1024, 4096 samples:\n");
    for (const double radius_m : benchmark.radii_m) print_slopes(reference, view.camera, radius_m);
    const std::vector<double> single_rates = print_rates(scene, view.camera, benchmark);
    fmt::print("Time to the error:\n");
    for (std::size_t i = 0; i < benchmark.radii_m.size(); ++i) {
        print_time_to_error(reference, view.camera, benchmark, benchmark.radii_m[i], single_rates[i]);
        std::fflush(stdout);
    }
    fmt::print("Peak memory of the whole process so far: {:.0f} MiB\n", peak_memory_mib());
    if (benchmark.growth) print_growth(scene, reference, view.camera, benchmark);
}

}  // namespace aoscore
