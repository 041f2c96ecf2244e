// Tests a plan's jobs, listed and made one by one, as on a cluster.
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

const std::string kScore = "score wall --view facing --methods hbao,alchemy --size 48x32 --samples 4";
const std::string kStress = "stress --quick --methods alchemy --axes tilt";

json listed(const std::string& command, const std::filesystem::path& folder) {
    const auto run = run_aoscore(command + " --jobs", folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(run.out);
}

std::filesystem::file_time_type newest_entry(const std::filesystem::path& folder) {
    std::filesystem::file_time_type newest{};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "truth-cache")) {
        if (entry.is_regular_file()) newest = std::max(newest, entry.last_write_time());
    }
    return newest;
}

// Makes all artifacts that the command asks for, each by a process of its own.
void make_one_by_one(const std::string& command, const std::filesystem::path& folder) {
    const json before = listed(command, folder);
    ASSERT_FALSE(before.at("jobs").empty());
    for (const json& job : before.at("jobs")) {
        EXPECT_FALSE(job.at("known") == true);
        if (!job.at("asked")) continue;
        const auto made = run_aoscore("job " + job.at("key").get<std::string>(), folder);
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    const json after = listed(command, folder);
    for (const json& job : after.at("jobs")) {
        EXPECT_TRUE(!job.at("asked") || job.at("known") == true) << job;
    }
}

TEST(Job, OfAScoreMadeOneByOneLeaveNothingToDo) {
    const auto folder = output_dir();
    make_one_by_one(kScore, folder);
    ASSERT_EQ(run_aoscore(kScore + " --out out", folder).exit_code, 0);
    const Results results = read_results(folder / "out");
    EXPECT_EQ(results.work.cells_reused, 2u);
    EXPECT_EQ(results.work.passes, 0u);
    EXPECT_EQ(results.work.rays, 0u);
}

TEST(Job, OfAStressTestMadeOneByOneLeaveNothingToRun) {
    const auto folder = output_dir();
    make_one_by_one(kStress, folder);
    const std::filesystem::file_time_type made = newest_entry(folder);
    ASSERT_EQ(run_aoscore(kStress + " --out out", folder).exit_code, 0);
    EXPECT_EQ(newest_entry(folder), made) << "something was made again";
}

TEST(Job, EveryInputOfAListedJobIsListed) {
    for (const std::string& command : {kScore, kStress}) {
        const json jobs = listed(command, output_dir()).at("jobs");
        std::set<std::string> keys;
        for (const json& job : jobs) EXPECT_TRUE(keys.insert(job.at("key")).second) << "each once";
        for (const json& job : jobs) {
            for (const json& input : job.at("inputs")) EXPECT_TRUE(keys.contains(input)) << job;
            for (const json& earlier : job.at("after")) EXPECT_TRUE(keys.contains(earlier)) << job;
        }
    }
}

TEST(Job, ThatNobodyListedIsRefused) {
    const auto run = run_aoscore("job 0123", output_dir());
    EXPECT_EQ(run.exit_code, 64);
    EXPECT_THAT(run.err, HasSubstr("--jobs"));
}

}  // namespace
}  // namespace aoscore
