#include "core/files.h"
#include "results/results.h"
#include "results/upgrade/schema_upgrade.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_aoscore;

TEST(IndexCommand, ReadsResultsOfAnyAgeAndGoesOnPastThoseItCannotRead) {
    const fs::path folder = testing::output_dir();
    fs::copy(testing::source_dir() / "tests/results/older", folder / "older", fs::copy_options::recursive);
    write_atomically(folder / "older/broken/results.json", "{\"schema_version\": 1}");
    const ProgramRun run = run_aoscore("index older nowhere --out all", folder);
    EXPECT_EQ(run.exit_code, 5) << run.err;
    EXPECT_EQ(run.out, "all/index.html\n");
    const std::string page = read_file(folder / "all/index.html");
    EXPECT_THAT(page, HasSubstr(fmt::format("This index holds {} runs with",
                                            Results::kSchemaVersion - kOldestSchema)));
    EXPECT_THAT(page, HasSubstr("2 files could not be read"));
    EXPECT_THAT(page, HasSubstr("of too old a version of this program"));
    EXPECT_THAT(page, HasSubstr("no results.json lies in it or below"));
    for (const char* name : {"HBAO", "Alchemy AO", "GTAO", "\"pillar\"", "\"wall\""})
        EXPECT_THAT(page, HasSubstr(name));
}

TEST(IndexCommand, WithoutAnyResultsSaysSoAndWritesNothing) {
    const fs::path folder = testing::output_dir();
    const ProgramRun run = run_aoscore("index . --out all", folder);
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_THAT(run.err, HasSubstr("no results could be read"));
    EXPECT_FALSE(fs::exists(folder / "all"));
    EXPECT_EQ(run_aoscore("index", folder).exit_code, 64) << "index what?";
}

TEST(IndexCommand, TakesNoRunsPlace) {
    const fs::path folder = testing::output_dir();
    fs::copy(testing::source_dir() / "tests/results/older", folder / "older", fs::copy_options::recursive);
    for (const char* results : {"results.json", "stress.json", "tune.json"}) {
        write_atomically(folder / "run" / results, "{}");
        write_atomically(folder / "run/index.html", "the run's page");
        const ProgramRun run = run_aoscore("index older --out run", folder);
        EXPECT_EQ(run.exit_code, 64) << results << run.err;
        EXPECT_THAT(run.err, HasSubstr("a folder of its own")) << results;
        EXPECT_EQ(read_file(folder / "run/index.html"), "the run's page") << results;
        fs::remove_all(folder / "run");
    }
}

TEST(IndexCommand, RanksOverScenesTheResultsOfSeveralRuns) {
    const fs::path folder = testing::output_dir();
    for (const char* scene : {"wall --view facing", "pillar --view main"}) {
        const std::string score = std::string("score ") + scene +
                                  " --size 48x32 --samples 4 --methods hbao,alchemy --out runs/" +
                                  std::string(scene, 4);
        ASSERT_EQ(run_aoscore(score, folder).exit_code, 0);
    }
    const ProgramRun run = run_aoscore("index runs", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string page = read_file(folder / "index/index.html");
    EXPECT_THAT(page, HasSubstr("2 methods to the ray-traced truth over 2 scenes with 2 views"));
    EXPECT_THAT(page, HasSubstr("../runs/wall/index.html#view=wall/facing"));
}

}  // namespace
}  // namespace aoscore
