#include "bench/bench_compare.h"

#include "bench/cost.h"
#include "bench/made_up_pair.h"
#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/output.h"
#include "core/temporary_folder.h"
#include "metrics/analysis/analysis.h"
#include "metrics/evaluate.h"
#include "metrics/prepared_halves.h"
#include "metrics/roles.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

namespace aoscore {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kRuns = 5;
constexpr char kPlainPass[] = "RMSE, one plain pass";

double fastest_ms(const std::function<void()>& work) {
    Cost least;
    for (int run = 0; run < kRuns; ++run) least.keep_least(cost_of(work));
    return 1000 * least.processor_s;
}

/// As one would write it down: both images read once, by one thread.
double plain_rmse(const ImageF& truth, const ImageF& test) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = double{test.pixels[i]} - double{truth.pixels[i]};
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(truth.size()));
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
                    folder.string(), (data_dir() / "src/bench/skimage_ssim.py").string(), kWidth, kHeight);
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    std::istringstream said(read_file(folder / "ssim.txt"));
    ScikitImage answer;
    said >> answer.value;
    for (Cost* cost : {&answer.in_double, &answer.in_single}) said >> cost->wall_s >> cost->processor_s;
    return answer;
}

/// Beside ours, which is in the table as `name`.
void compare_ssim(const MadeUpPair& pair, const MetricInput& input, const std::string& name,
                  RatioTable& table) {
    const TemporaryFolder folder;
    write_raw(folder.path() / "truth.raw", pair.truth);
    write_raw(folder.path() / "test.raw", pair.test);
    std::optional<ScikitImage> theirs;
    for (int i = 0; i < kRuns; ++i) {
        const std::optional<ScikitImage> run = ask_scikit_image(folder.path());
        if (!run) break;
        if (!theirs) theirs = run;
        theirs->in_double.keep_least(run->in_double);
        theirs->in_single.keep_least(run->in_single);
    }
    if (!theirs) {
        print_result("python3-skimage is not there to compare with\n");
        return;
    }
    print_result("SSIM is {:.12f}, by scikit-image {:.12f}\n", *metric(kStructureMetric).measure(input).value,
                 theirs->value);
    table.add("SSIM by scikit-image, double", 1000 * theirs->in_double.processor_s, kProcessorMs, name);
    table.add("SSIM by scikit-image, single", 1000 * theirs->in_single.processor_s, kProcessorMs, name);
}

/// The cost of one more image of a view, against a truth of two halves.
void score_halves(const MadeUpPair& pair, const Mask& valid, std::uint64_t seed, RatioTable& table) {
    const PreparedHalves kept(pair.truth, pair.first_half, pair.second_half, valid);
    const auto score = [&](bool prepared) {
        MapSums maps, first_maps, second_maps, noisy_maps;
        TruthHalves halves{pair.first_half, pair.second_half, &first_maps, &second_maps,
                           nullptr,         &noisy_maps,      64};
        MetricInput input{pair.truth, pair.test, valid};
        input.maps = &maps;
        input.halves = &halves;
        if (prepared) halves.prepared = &kept;
        evaluate(input);
        analyse(input, {}, kMaskThreshold, seed);
    };
    const std::string plain = "score of an image, truth in halves";
    table.add(plain, fastest_ms([&] { score(false); }), kProcessorMs);
    table.add("the same, the truth prepared", fastest_ms([&] { score(true); }), kProcessorMs, plain);
}

}  // namespace

void bench_compare(std::uint64_t seed, RatioTable& table) {
    const MadeUpPair pair(kWidth, kHeight, seed);
    const Mask valid(kWidth, kHeight, 1);
    const ImageF standard_error(kWidth, kHeight, 0.02F);
    MapSums maps;
    const MetricInput input{pair.truth, pair.test, valid, &standard_error, &maps};
    double rmse = 0;
    table.add(kPlainPass, fastest_ms([&] { rmse += plain_rmse(pair.truth, pair.test); }), kProcessorMs);
    if (!std::isfinite(rmse)) throw internal_error("two made-up images differ by no number");
    for (const Metric& row : metrics())
        table.add(std::string(row.label), fastest_ms([&] { row.measure(input); }), kProcessorMs, kPlainPass);
    table.add("all metrics together", fastest_ms([&] { evaluate(input); }), kProcessorMs, kPlainPass);
    table.add("analysis, with intervals", fastest_ms([&] { analyse(input, {}, kMaskThreshold, seed); }),
              kProcessorMs, kPlainPass);
    score_halves(pair, valid, seed, table);
    compare_ssim(pair, input, std::string(metric(kStructureMetric).label), table);
}

}  // namespace aoscore
