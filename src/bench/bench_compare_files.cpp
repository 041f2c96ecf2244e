#include "bench/bench_compare.h"
#include "bench/cost.h"
#include "bench/made_up_pair.h"
#include "core/error.h"
#include "core/output.h"
#include "core/processes/program_path.h"
#include "core/temporary_folder.h"
#include "image/image_file.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr int kFileWidth = 3840, kFileHeight = 2160;
constexpr int kFileRuns = 3;

std::string written(const std::filesystem::path& path, const ImageF& image) {
    const std::vector<ChannelView> channels{{"Y", &image}};
    write_exr(path, channels, {});
    return path.string();
}

/// The images are gone when this returns: a program's peak memory is never below that of the one that starts
/// it.
std::pair<std::string, std::string> written_pair(const std::filesystem::path& folder, std::uint64_t seed) {
    const MadeUpPair pair(kFileWidth, kFileHeight, seed);
    return {written(folder / "truth.exr", pair.truth), written(folder / "test.exr", pair.test)};
}

}  // namespace

void bench_compare_files(std::uint64_t seed, RatioTable& table) {
    const TemporaryFolder folder;
    const auto [truth, test] = written_pair(folder.path(), seed);
    const std::string self = program_path().string();
    Cost ours, theirs;
    bool has_idiff = true;
    for (int run = 0; run < kFileRuns; ++run) {
        const auto compared = cost_of_program({self, "compare", truth, test});
        if (!compared) throw internal_error("compare fails on two images of its own");
        ours.keep_least(*compared);
        const auto different = cost_of_program({"idiff", "-q", truth, test}, 2);
        has_idiff = has_idiff && different.has_value();
        if (has_idiff) theirs.keep_least(*different);
    }
    const std::string size = ", two EXR of 3840x2160", memory = ", its peak memory";
    if (!has_idiff) {
        print_result("idiff (openimageio-tools) is not there to compare with\n");
        table.add("aoscore compare" + size, ours.processor_s, "processor s");
        table.add("aoscore compare" + memory, ours.peak_memory_mib, "MiB");
        return;
    }
    table.add("idiff" + size, theirs.processor_s, "processor s");
    table.add("aoscore compare" + size, ours.processor_s, "processor s", "idiff" + size);
    table.add("idiff" + memory, theirs.peak_memory_mib, "MiB");
    table.add("aoscore compare" + memory, ours.peak_memory_mib, "MiB", "idiff" + memory);
}

}  // namespace aoscore
