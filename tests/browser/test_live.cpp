#include "browser/browser_support.h"
#include "core/files.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cstdlib>

/// The page's live methods are the program's: WebGL 2 draws what OpenGL 3.3 drew, cell by cell.
namespace aoscore {
namespace {

namespace fs = std::filesystem;

struct LiveCase {
    const char* name;
    const char* arguments;      ///< of score, after the scene
    double least_near = 0.995;  ///< share of the pixels that must be within 2/255
};

class LivePictures : public ::testing::TestWithParam<LiveCase> {};

TEST_P(LivePictures, EqualTheStoredOnes) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        std::string("score atrium --size 160x96 --samples 16 --quiet --out measured ") + GetParam().arguments,
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path measured = folder / "measured";
    write_atomically(folder / "values.json", testing::exr_values(read_results(measured), measured).dump());
    write_atomically(folder / "case.json", nlohmann::json{{"least_near", GetParam().least_near}}.dump());
    testing::expect_spec_holds("live-pictures.mjs", folder);
}

constexpr LiveCase kCases[] = {
    {"every_method", "--view close --methods all"},
    // Without a filter to even them out, taps and sectors that roundings push over an edge stand out whole.
    {"every_method_unfiltered", "--view close --methods all --filter none", 0.99},
    {"gaussian_depth", "--view wide --methods hbao,ssao --filter gaussian-depth"},
    {"normal_depth", "--view close --methods hbao,ssao --filter normal-depth"},
    {"border_clamp", "--view close --methods alchemy,gtao,xegtao --border clamp"},
    {"another_seed", "--seed 77 --view wide --methods ssao,alchemy,hbao"},
};
INSTANTIATE_TEST_SUITE_P(Page, LivePictures, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace aoscore
