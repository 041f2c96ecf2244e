#include "experiment/bench_compare.h"

#include "core/files.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "experiment/machine.h"
#include "metrics/analysis.h"
#include "metrics/evaluate.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <sstream>

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

double fastest(const std::function<void()>& work, int runs = kRuns) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < runs; ++i) {
        const Stopwatch watch;
        work();
        least = std::min(least, watch.seconds());
    }
    return least;
}

void write_raw(const std::filesystem::path& path, const ImageF& image) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(image.pixels.data()),
               static_cast<std::streamsize>(image.size() * sizeof(float)));
}

/// What scikit-image says and how long it takes: value, fastest double and single run. Empty without it.
std::vector<double> ask_scikit_image(const std::filesystem::path& folder) {
    const std::string command = fmt::format(
        "cd '{}' && /usr/bin/python3 '{}' {} {} truth.raw test.raw {} >ssim.txt 2>/dev/null", folder.string(),
        (home_dir() / "src/experiment/skimage_ssim.py").string(), kWidth, kHeight, 1);
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
    std::istringstream lines(read_file(folder / "ssim.txt"));
    std::vector<double> numbers(3);
    for (double& number : numbers) lines >> number;
    return numbers;
}

void compare_ssim(const Pair& pair, const std::function<double()>& ours) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("aoscore-bench-{}", getpid());
    std::filesystem::create_directories(folder);
    write_raw(folder / "truth.raw", pair.truth);
    write_raw(folder / "test.raw", pair.test);
    double value = 0, theirs = 0, our_s = std::numeric_limits<double>::infinity(), double_s = our_s,
           single_s = our_s;
    for (int i = 0; i < kRuns; ++i) {
        our_s = std::min(our_s, fastest([&] { value = ours(); }, 1));
        const std::vector<double> numbers = ask_scikit_image(folder);
        if (numbers.empty()) {
            fmt::print("{:<34} {:>9}  python3-skimage is not there\n", "SSIM by scikit-image", "-");
            break;
        }
        theirs = numbers[0];
        double_s = std::min(double_s, numbers[1]);
        single_s = std::min(single_s, numbers[2]);
    }
    std::filesystem::remove_all(folder);
    fmt::print("{:<34} {:>9.1f} ms  {:.12f}\n", "SSIM", 1000 * our_s, value);
    if (!std::isfinite(double_s)) return;
    fmt::print("{:<34} {:>9.1f} ms  {:.12f}, {:.1f} times ours\n", "SSIM by scikit-image, double",
               1000 * double_s, theirs, double_s / our_s);
    fmt::print("{:<34} {:>9.1f} ms  {:.1f} times ours\n", "SSIM by scikit-image, single", 1000 * single_s,
               single_s / our_s);
}

}  // namespace

void bench_compare(std::uint64_t seed) {
    const Pair pair = made_up_pair(seed);
    const Mask valid(kWidth, kHeight, 1);
    const ImageF standard_error(kWidth, kHeight, 0.02F);
    const MetricInput input{pair.truth, pair.test, valid, &standard_error};
    fmt::print("{}, {} threads; {}x{}, fastest of {} runs\n", cpu_name(), thread_count(), kWidth, kHeight,
               kRuns);
    compare_ssim(pair, [&] { return *metric("ssim").measure(input).value; });
    for (const Metric& row : metrics()) {
        fmt::print("{:<34} {:>9.1f} ms\n", row.label, 1000 * fastest([&] { row.measure(input); }));
    }
    fmt::print("{:<34} {:>9.1f} ms\n", "all metrics together", 1000 * fastest([&] { evaluate(input); }));
    fmt::print("{:<34} {:>9.1f} ms\n", "analysis",
               1000 * fastest([&] { analyse(input, {}, kMaskThreshold, seed); }));
}

}  // namespace aoscore
