// `aoscore worst`: a score of the views that it found confirms what it says of them.
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

/// The numbers that are printed behind "worst_1", "worst_2", …
std::vector<double> confirmed_in(const std::string& printed) {
    std::vector<double> numbers;
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string id;
        double number = 0;
        if (words >> id >> number && id.starts_with("worst_")) numbers.push_back(number);
    }
    return numbers;
}

double rmse(const std::filesystem::path& folder, const std::string& view, const std::string& method) {
    const Results results = read_results(folder);
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key.ends_with(view) && cell.method == method)
            return *cell.ranked.at("rmse_debiased").value;
    }
    ADD_FAILURE() << "no cell of " << method << " on " << view;
    return 0;
}

TEST(Worst, FindsViewsThatAreWorseThanMostAndThatTheirScoreConfirms) {
    const auto folder = output_dir();
    const ProgramRun run = run_aoscore(
        "worst pillar --methods hbao --cameras 24 --count 3 --size 160x90 --samples 128 --out found", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::vector<double> confirmed = confirmed_in(run.out);
    ASSERT_EQ(confirmed.size(), 3U) << run.out;
    EXPECT_TRUE(std::ranges::is_sorted(confirmed, std::greater()));
    EXPECT_THAT(run.out, HasSubstr("not the worst there is"));
    for (std::size_t i = 0; i < confirmed.size(); ++i) {
        EXPECT_NEAR(rmse(folder / "found", "worst_" + std::to_string(i + 1), "hbao"), confirmed[i], 0.004);
    }
    // The file is one for --views, too; the scene's own views err less.
    const ProgramRun again = run_aoscore(
        "score pillar --views found/pillar.views.json --view worst_1 --methods hbao --size 160x90 --samples "
        "128 --out again",
        folder);
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_NEAR(rmse(folder / "again", "worst_1", "hbao"), confirmed[0], 0.004);
}

TEST(Worst, FindsWhereOneMethodIsFarthestBehindAnother) {
    const auto folder = output_dir();
    const ProgramRun run = run_aoscore(
        "worst pillar --between crytek-ssao,gtao --cameras 12 --count 1 --size 160x90 --samples 128 --out "
        "found",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::vector<double> confirmed = confirmed_in(run.out);
    ASSERT_EQ(confirmed.size(), 1U);
    EXPECT_NEAR(rmse(folder / "found", "worst_1", "crytek-ssao") - rmse(folder / "found", "worst_1", "gtao"),
                confirmed[0], 0.004);
}

TEST(Worst, SaysWhatItNeeds) {
    const auto folder = output_dir();
    for (const char* arguments : {"worst pillar", "worst pillar --methods hbao --between hbao,gtao",
                                  "worst pillar --between hbao", "worst pillar --methods nonsense"}) {
        EXPECT_EQ(run_aoscore(arguments, folder).exit_code, 64) << arguments;
    }
    const std::pair<const char*, const char*> refused[] = {
        {"--between gtao,gtao", "gtao cannot be behind itself"},
        {"--methods hbao --between hbao,gtao", "both say what to judge by"},
        {"--methods hbao --fail 'nope>1'", "nope"},
        {"--methods hbao,gtao --fail 'rmse>1'", "one method"},
        {"--methods hbao,gtao --export o.csv", "one method"},
        {"--methods hbao --export o.doc", "o.doc"}};
    for (const auto& [options, words] : refused) {
        const ProgramRun run = run_aoscore(
            std::string("worst pillar --cameras 4 --size 64x36 --samples 4 --out o ") + options, folder);
        EXPECT_EQ(run.exit_code, 64) << options << run.err;
        EXPECT_THAT(run.err, HasSubstr(words)) << options;
        EXPECT_EQ(run.out, "") << options << ": a fault costs no search";
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "o"));
    // Far above the building no camera sees a surface.
    for (const char* command :
         {"worst pillar --methods hbao --cameras 10", "export-training pillar --views 1"}) {
        const ProgramRun run =
            run_aoscore(std::string(command) + " --height 50 --size 64x36 --out o", folder);
        EXPECT_EQ(run.exit_code, 2) << command << run.err;
        EXPECT_THAT(run.err, ::testing::AllOf(HasSubstr("pillar: none of the 10"), HasSubstr("--height")));
        EXPECT_FALSE(std::filesystem::exists(folder / "o"));
    }
}

}  // namespace
}  // namespace aoscore
