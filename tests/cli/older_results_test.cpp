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
using nlohmann::json;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_aoscore;

class OlderResults : public ::testing::TestWithParam<int> {};

TEST_P(OlderResults, BecomeAPageWithTheirNumbersAndWithWhatTheyDoNotSay) {
    const fs::path folder = testing::output_dir();
    const std::string name = fmt::format("schema-{}", GetParam());
    fs::copy(testing::source_dir() / "tests/results/older" / name, folder / name,
             fs::copy_options::recursive);
    const std::string before = read_file(folder / name / "results.json");
    const ProgramRun run = run_aoscore("page " + name, folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(read_file(folder / name / "results.json"), before) << "the old file was written over";
    const std::string page = read_file(folder / name / "index.html");
    EXPECT_THAT(page, HasSubstr(fmt::format("These results are of schema {}", GetParam())));
    for (const char* section : {"verdict", "ranking", "pictures", "failures", "distributions", "measurement"})
        EXPECT_THAT(page, HasSubstr(fmt::format("<section id=\"{}\"", section)));
    for (const json& cell : json::parse(before).at("cells")) {
        const double error = cell.at("ranked").at("rmse_debiased").at("value");
        EXPECT_THAT(page, HasSubstr(fmt::format(">{:.4f}<", error))) << cell.at("id");
        EXPECT_THAT(page, HasSubstr("data-image=\"" + cell.at("id").get<std::string>() + " output\""));
    }
}

INSTANTIATE_TEST_SUITE_P(Each, OlderResults, ::testing::Range(kOldestSchema, Results::kSchemaVersion));

TEST(OlderBaseline, IsComparedWithARunOfToday) {
    const fs::path folder = testing::output_dir();
    const fs::path older = testing::source_dir() / "tests/results/older/schema-8";
    const ProgramRun run = run_aoscore(
        "score wall --view facing --size 48x32 --samples 4 --methods hbao,alchemy --out now --baseline " +
            older.string(),
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    // The same rays, but other stated errors, by which four rays are debiased.
    EXPECT_THAT(run.err, HasSubstr("another version of the ray tracer"));
    const json baseline = json::parse(read_file(folder / "now/results.json")).at("baseline");
    ASSERT_EQ(baseline.at("changes").size(), 2u);
    for (const json& change : baseline.at("changes"))
        EXPECT_NE(change.at("verdict"), "not comparable") << change.at("reason");
}

}  // namespace
}  // namespace aoscore
