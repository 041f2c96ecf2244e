#include "reference/benchmark.h"

#include "core/machine.h"
#include "core/threads.h"
#include "reference/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

constexpr int kSlopeWidth = 64, kSlopeHeight = 36;
constexpr int kSlopeSeeds = 4;

/// Processor time of all threads, divided among them: the time it takes on a machine that does nothing else.
double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / thread_count();
}

double mean_error(const Truth& truth) {
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        sum += truth.standard_error[0].pixels[i];
        pixels += truth.hits.surface.pixels[i];
    }
    return sum / pixels;
}

/// Plain Monte Carlo over the pixels of a truth: what it would state, by the same rules.
class PlainMonteCarlo {
  public:
    explicit PlainMonteCarlo(const Truth& truth) {
        for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
            const double v = truth.visibility[0].pixels[i];
            if (truth.hits.surface.pixels[i] != 0) deviations_.push_back(std::sqrt(v * (1 - v)));
        }
    }
    double pixels() const { return static_cast<double>(deviations_.size()); }

    /// Rays a pixel, the same for all, until the mean standard error, floor included, is `error`.
    double samples_for(double error) const {
        double low = 1, high = kMostSamples;
        while (high / low > 1.001) {
            const double samples = std::sqrt(low * high);
            double sum = 0;
            for (const double d : deviations_) sum += std::max(d / std::sqrt(samples), 0.5 / samples);
            (sum / pixels() > error ? low : high) = samples;
        }
        return high;
    }

    /// Rays a pixel in the mean, if each pixel got as many as are best for the mean standard error and the
    /// floor did not count: n ~ deviation^(2/3).
    double best_samples_for(double error) const {
        double sum = 0;
        for (const double d : deviations_) sum += std::cbrt(d * d);
        return std::pow(sum / pixels(), 3) / (error * error);
    }

  private:
    std::vector<double> deviations_;
};

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

/// The least count whose picture of a sixteenth of the pixels reaches the mean standard error.
int samples_to_error(const ReferenceScene& reference, const Camera& camera,
                     const ReferenceBenchmark& benchmark, double radius_m) {
    const CameraFrame pilot(camera, benchmark.width / 4, benchmark.height / 4);
    const auto error = [&](int samples) {
        return mean_error(reference.trace(pilot, binary(radius_m), with_samples(samples), "pilot"));
    };
    // A first guess by the law of the error, a little low.
    constexpr int kFirst = 64;
    const double guess = 0.6 * kFirst * std::pow(error(kFirst) / benchmark.target_error, 4.0 / 3);
    int samples = 4;
    while (samples < guess) samples = next_count(samples);
    while (error(samples) > benchmark.target_error) samples = next_count(samples);
    return samples;
}

void print_time_to_error(const ReferenceScene& reference, const Camera& camera,
                         const ReferenceBenchmark& benchmark, double radius_m, double single_rate) {
    const CameraFrame frame(camera, benchmark.width, benchmark.height);
    const int samples = samples_to_error(reference, camera, benchmark, radius_m);
    Truth truth;
    const double seconds =
        seconds_of([&] { truth = reference.trace(frame, binary(radius_m), with_samples(samples), "truth"); });
    const PlainMonteCarlo plain(truth);
    const auto plain_seconds = [&](double count) { return count * plain.pixels() / (single_rate * 1e6); };
    // To the error that was reached, be it a little above or below the target.
    const double error = mean_error(truth);
    const double count = plain.samples_for(error), best = plain.best_samples_for(error);
    fmt::print(
        "R {:>6} m: {} samples, {:.1f} s to a mean standard error of {:.5f} ({:.0f} M rays, {:.1f} % of "
        "pixels proven open)\n",
        radius_m, samples, seconds, error, static_cast<double>(truth.rays) / 1e6,
        100.0 * static_cast<double>(truth.open_pixels) / plain.pixels());
    fmt::print(
        "            plain Monte Carlo by rtcOccluded1: {:.0f} samples, {:.0f} s, {:.1f} times as long; with "
        "the best allocation over pixels, the floor left out, {:.0f} samples, {:.1f} times\n",
        count, plain_seconds(count), plain_seconds(count) / seconds, best, plain_seconds(best) / seconds);
    if (best < 1)
        fmt::print("            all pixels are open or blocked: only the stated floor is compared\n");
    const CameraFrame small(camera, benchmark.width / 4, benchmark.height / 4);
    TruthSettings adaptive = with_samples(16);
    adaptive.max_error = benchmark.target_error;
    const double adaptive_seconds =
        seconds_of([&] { truth = reference.trace(small, binary(radius_m), adaptive, "adaptive"); });
    fmt::print(
        "            every pixel to {}, at a quarter of the width: {} samples in the mean, {:.1f} s, mean "
        "standard error {:.5f}\n",
        benchmark.target_error, truth.samples, adaptive_seconds, mean_error(truth));
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

/// Every triangle cut into four at the middles of its edges.
Scene refined(Scene scene) {
    for (Mesh& mesh : scene.meshes) {
        Mesh fine;
        fine.material = mesh.material;
        for (const glm::uvec3& t : mesh.triangles) {
            const auto first = static_cast<unsigned>(fine.positions.size());
            const auto add = [&](unsigned i, unsigned j) {
                fine.positions.push_back((mesh.positions[i] + mesh.positions[j]) * 0.5f);
                if (!mesh.texcoords.empty())
                    fine.texcoords.push_back((mesh.texcoords[i] + mesh.texcoords[j]) * 0.5f);
            };
            add(t.x, t.x), add(t.y, t.y), add(t.z, t.z), add(t.x, t.y), add(t.y, t.z), add(t.z, t.x);
            for (const glm::uvec3& part :
                 {glm::uvec3(0, 3, 5), glm::uvec3(3, 1, 4), glm::uvec3(5, 4, 2), glm::uvec3(3, 4, 5)}) {
                fine.triangles.push_back(part + first);
            }
        }
        mesh = std::move(fine);
    }
    return scene;
}

void print_growth(const Scene& scene, const ReferenceScene& reference, const Camera& camera,
                  const ReferenceBenchmark& benchmark, double radius_m) {
    fmt::print("Growth with pixels, 64 samples, R {} m:", radius_m);
    for (const int part : {4, 2, 1}) {
        const CameraFrame frame(camera, benchmark.width / part, benchmark.height / part);
        const double seconds =
            seconds_of([&] { reference.trace(frame, binary(radius_m), with_samples(64), "growth"); });
        fmt::print(" {}x{} {:.2f} s ({:.2f} us a pixel)", frame.width(), frame.height(), seconds,
                   seconds * 1e6 / frame.width() / frame.height());
    }
    fmt::print("\nGrowth with triangles, 64 samples, R {} m:", radius_m);
    const CameraFrame frame(camera, benchmark.width / 2, benchmark.height / 2);
    Scene fine = scene;
    std::size_t triangles = 0;
    std::vector<double> times;
    for (const Instance& i : scene.instances)
        triangles += scene.meshes[static_cast<std::size_t>(i.mesh)].triangles.size();
    for (int level = 0; level < 3; ++level, triangles *= 4) {
        if (level > 0) fine = refined(std::move(fine));
        const ReferenceScene finer(fine, TraceBuild{100'000'000});
        const double seconds =
            seconds_of([&] { finer.trace(frame, binary(radius_m), with_samples(64), "growth"); });
        fmt::print(" {} {:.2f} s", triangles, seconds);
        std::fflush(stdout);
        times.push_back(seconds);
    }
    // Between four and sixteen times as many, by the power law through both.
    const double tenfold = times[1] * std::pow(times[2] / times[1], std::log(10.0 / 4) / std::log(16.0 / 4));
    fmt::print("; tenfold (interpolated): {:.2f} times as long\n", tenfold / times[0]);
}

}  // namespace

void reference_benchmark(const Scene& scene, const View& view, const ReferenceBenchmark& benchmark) {
    std::optional<ReferenceScene> built;
    const double build_s = seconds_of([&] { built.emplace(scene); });
    const ReferenceScene& reference = *built;
    const EmbreeScene embree(scene, {});
    fmt::print("{}/{}: {} triangles, {}x{}, {} threads; built in {:.2f} s, {} MB in Embree\n", scene.id,
               view.id, scene.triangle_count, benchmark.width, benchmark.height, thread_count(), build_s,
               reference.peak_bytes() / 1'000'000);
    const CameraFrame frame(view.camera, benchmark.width, benchmark.height);
    fmt::print("Million rays a second, {} rays a pixel, {} random tiles:\n", benchmark.samples,
               benchmark.tiles);
    std::vector<double> single_rates;
    for (const double radius_m : benchmark.radii_m) {
        const ReplayRates rates = replay_rates(embree, frame, radius_m, benchmark.samples, benchmark.tiles);
        single_rates.push_back(rates.single);
        fmt::print(
            "R {:>6} m: traced {:.1f} | replays: rtcOccluded1 {:.1f}, 16 of a pixel {:.1f}, 16 of a block "
            "{:.1f}, "
            "16 as traced {:.1f} | traced / best replay {:.3f}\n",
            radius_m, rates.traced, rates.single, rates.pixel, rates.block, rates.sorted,
            rates.traced / rates.best());
        std::fflush(stdout);
    }
    fmt::print("Time to the error:\n");
    for (std::size_t i = 0; i < benchmark.radii_m.size(); ++i) {
        print_time_to_error(reference, view.camera, benchmark, benchmark.radii_m[i], single_rates[i]);
        std::fflush(stdout);
    }
    fmt::print("Peak memory of the whole process so far: {:.0f} MiB\n", peak_memory_mib());
    fmt::print("Root-mean-square error at 16, 64, 256, 1024, 4096 samples:\n");
    for (const double radius_m : benchmark.radii_m) print_slopes(reference, view.camera, radius_m);
    if (benchmark.growth) print_growth(scene, reference, view.camera, benchmark, benchmark.radii_m.front());
}

}  // namespace aoscore
