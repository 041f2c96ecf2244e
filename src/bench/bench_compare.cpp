#include "bench/bench_compare.h"

#include "core/files.h"
#include "core/machine.h"
#include "core/output.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "metrics/analysis/analysis.h"
#include "metrics/evaluate.h"
#include "metrics/roles.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string_view>
#include <vector>

namespace aoscore {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kRuns = 5;

struct Pair {
    ImageF truth{kWidth, kHeight}, test{kWidth, kHeight};
};

/// Slopes, edges and noise.
Pair made_up_pair(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> noise(-0.05F, 0.05F);
    Pair pair;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float slope =
                0.6F + 0.25F * std::sin(0.011F * static_cast<float>(x) + 0.007F * static_cast<float>(y));
            const float edge = (x / 171 + y / 97) % 3 == 0 ? 0.2F : 0.0F;
            pair.truth.at(x, y) = slope - edge + noise(random);
            pair.test.at(x, y) = 0.9F * slope - 0.5F * edge + 0.1F + noise(random);
        }
    }
    return pair;
}

/// By the wall clock, and processor time, which other programs hardly touch.
struct Cost {
    double wall_s = std::numeric_limits<double>::infinity(), processor_s = wall_s;
    void keep_least(const Cost& other) {
        wall_s = std::min(wall_s, other.wall_s);
        processor_s = std::min(processor_s, other.processor_s);
    }
};

Cost cost_of(const std::function<void()>& work) {
    const Stopwatch watch;
    const std::clock_t start = std::clock();
    work();
    return {watch.seconds(), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

void print_cost(std::string_view what, const Cost& cost, const std::string& note = {}) {
    print_result("{:<30} {:>8.1f} ms {:>8.1f} ms processor  {}\n", what, 1000 * cost.wall_s,
                 1000 * cost.processor_s, note);
}

void measure(std::string_view what, const std::function<void()>& work) {
    Cost least;
    for (int i = 0; i < kRuns; ++i) least.keep_least(cost_of(work));
    print_cost(what, least);
}

void write_raw(const std::filesystem::path& path, const ImageF& image) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(image.pixels.data()),
               static_cast<std::streamsize>(image.size() * sizeof(float)));
}

struct ScikitImage {
    double value = 0;
    Cost in_double, in_single;
};

/// Empty without it.
std::optional<ScikitImage> ask_scikit_image(const std::filesystem::path& folder) {
    const std::string command =
        fmt::format("cd '{}' && /usr/bin/python3 '{}' {} {} truth.raw test.raw 1 >ssim.txt 2>/dev/null",
                    folder.string(), (home_dir() / "src/bench/skimage_ssim.py").string(), kWidth, kHeight);
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    std::istringstream said(read_file(folder / "ssim.txt"));
    ScikitImage answer;
    said >> answer.value;
    for (Cost* cost : {&answer.in_double, &answer.in_single}) said >> cost->wall_s >> cost->processor_s;
    return answer;
}

std::string times(const Cost& theirs, const Cost& ours) {
    return fmt::format("{:.1f} times ours, {:.1f} by processor time", theirs.wall_s / ours.wall_s,
                       theirs.processor_s / ours.processor_s);
}

void compare_ssim(const Pair& pair, const std::function<double()>& ssim) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("aoscore-bench-{}", getpid());
    std::filesystem::create_directories(folder);
    write_raw(folder / "truth.raw", pair.truth);
    write_raw(folder / "test.raw", pair.test);
    double value = 0;
    Cost ours;
    std::optional<ScikitImage> theirs;
    for (int i = 0; i < kRuns; ++i) {
        ours.keep_least(cost_of([&] { value = ssim(); }));
        const std::optional<ScikitImage> run = ask_scikit_image(folder);
        if (!run) break;
        if (!theirs) theirs = run;
        theirs->in_double.keep_least(run->in_double);
        theirs->in_single.keep_least(run->in_single);
    }
    std::filesystem::remove_all(folder);
    print_cost("SSIM", ours, fmt::format("{:.12f}", value));
    if (!theirs) {
        print_result("python3-skimage is not there to compare with\n");
        return;
    }
    print_cost("SSIM by scikit-image, double", theirs->in_double,
               fmt::format("{:.12f}; {}", theirs->value, times(theirs->in_double, ours)));
    print_cost("SSIM by scikit-image, single", theirs->in_single, times(theirs->in_single, ours));
}

}  // namespace

void bench_compare(std::uint64_t seed) {
    const Pair pair = made_up_pair(seed);
    const Mask valid(kWidth, kHeight, 1);
    const ImageF standard_error(kWidth, kHeight, 0.02F);
    MapSums maps;
    const MetricInput input{pair.truth, pair.test, valid, &standard_error, &maps};
    print_result("{}, {} threads; {}x{}, fastest of {} runs\n", cpu_name(), thread_count(), kWidth, kHeight,
                 kRuns);
    compare_ssim(pair, [&] { return *metric(kStructureMetric).measure(input).value; });
    for (const Metric& row : metrics()) measure(row.label, [&] { row.measure(input); });
    measure("all metrics together", [&] { evaluate(input); });
    measure("analysis, with intervals", [&] { analyse(input, {}, kMaskThreshold, seed); });
}

}  // namespace aoscore
