// The settings in results make them again: filters' parameters, and the command of the truth.
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

const std::string kScore =
    "score pillar --view main --size 64x48 --samples 16 --methods alchemy,crytek-ssao --quiet ";

TEST(FilterParameters, AreSetOnTheCommandLineAndRecorded) {
    const auto folder = output_dir();
    const std::string score = kScore + "--filter gaussian-depth ";
    const ProgramRun usual = run_aoscore(score + "--out usual", folder);
    ASSERT_EQ(usual.exit_code, 0) << usual.err;
    const ProgramRun changed =
        run_aoscore(score + "--set filter.taps=1 filter.slope_correction=false --out changed", folder);
    ASSERT_EQ(changed.exit_code, 0) << changed.err;
    const Results before = read_results(folder / "usual"), after = read_results(folder / "changed");
    ASSERT_EQ(after.cells.size(), before.cells.size());
    for (std::size_t i = 0; i < after.cells.size(); ++i) {
        EXPECT_EQ(after.cells[i].parameters.at("filter.taps"), 1);
        EXPECT_EQ(after.cells[i].parameters.at("filter.slope_correction"), false);
        EXPECT_NE(read_image(folder / "changed" / after.cells[i].image_file).channel("Y")->pixels,
                  read_image(folder / "usual" / before.cells[i].image_file).channel("Y")->pixels);
    }
}

TEST(FilterParameters, ThatNoFilterTakesAreRefused) {
    const auto folder = output_dir();
    const auto refused = [&](const std::string& arguments, const char* text) {
        const ProgramRun run = run_aoscore(kScore + arguments, folder);
        EXPECT_EQ(run.exit_code, 64) << arguments;
        EXPECT_THAT(run.err, HasSubstr(text));
    };
    refused("--filter gaussian-depth --set filter.nonsense=1", "filter.nonsense");
    refused("--filter gaussian-depth --set taps=1", "taps");
    refused("--filter gaussian-depth --set filter.taps=99", "taps");
    refused("--filter none --set filter.taps=1", "filter.taps");
}

TEST(TruthEffort, BeginsWithAsFewRaysAsTellAnErrorUnlessNamed) {
    const auto folder = output_dir();
    const auto least_samples = [&](const std::string& effort) {
        const ProgramRun run = run_aoscore(
            "reference pillar --view main --size 32x24 --no-cache --quiet " + effort + " --out truth.exr",
            folder);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return read_image(folder / "truth.exr").attributes.at("aoscore:least_samples");
    };
    EXPECT_EQ(least_samples(""), "64");
    EXPECT_EQ(least_samples("--mean-error 0.05"), "16");
    EXPECT_EQ(least_samples("--error 0.2"), "16");
    EXPECT_EQ(least_samples("--mean-error 0.05 --samples 64"), "64");
}

TEST(TruthCommand, TracesTheSameBitsAgain) {
    const auto folder = output_dir();
    const ProgramRun run = run_aoscore(kScore + "--out o --seed 3", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ViewRecord view = read_results(folder / "o").views.at(0);
    EXPECT_EQ(view.least_samples, 16);
    const std::string program = "aoscore ";
    ASSERT_TRUE(view.truth_command.starts_with(program)) << view.truth_command;
    const ProgramRun again = run_aoscore(view.truth_command.substr(program.size()), folder);
    ASSERT_EQ(again.exit_code, 0) << view.truth_command << again.err;
    const ImageFile kept = read_image(folder / "o" / view.truth_file),
                    traced = read_image(folder / std::filesystem::path(view.truth_file).filename());
    for (const char* channel : {"V0.Y", "SE0.Y", "cause.hidden.Y", "one_layer.Y"}) {
        ASSERT_NE(kept.channel(channel), nullptr) << channel;
        ASSERT_NE(traced.channel(channel), nullptr) << channel;
        EXPECT_EQ(kept.channel(channel)->pixels, traced.channel(channel)->pixels) << channel;
    }
}

}  // namespace
}  // namespace aoscore
