// Tests score without --samples or --error: it traces as few rays as the scores need, and says so.
#include "core/files.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/roles.h"
#include "plan/plan.h"
#include "results/results.h"
#include "support/support.h"
#include "verdict/gate.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScore = "score pillar --size 160x96 --methods gtao,alchemy --out page";

TEST(ScoreGoal, LeavesEveryScoreAsSureAsItPromisesAndNearOneOfManyRays) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore(kScore, folder).exit_code, 0);
    ASSERT_EQ(
        run_aoscore("score pillar --size 160x96 --methods gtao,alchemy --samples 2048 --out many", folder)
            .exit_code,
        0);
    const Results few = read_results(folder / "page"), many = read_results(folder / "many");
    const ScoreGoal goal;
    ASSERT_EQ(few.cells.size(), many.cells.size());
    for (std::size_t i = 0; i < few.cells.size(); ++i) {
        const CellRecord& cell = few.cells[i];
        ASSERT_TRUE(cell.analysis) << cell.id << cell.error;
        ASSERT_TRUE(cell.analysis->truth_noise.contains(kRankingMetric));
        for (const auto& [metric, half_width] : cell.analysis->truth_noise) {
            if (is_mean_of_mask(metric)) continue;  // no score: no rays are traced for it
            const double allowed =
                metric == kRankingMetric ? goal.error : ScoreGoal::kOtherMetrics * goal.error;
            EXPECT_LE(half_width, allowed) << cell.id << " " << metric;
            // 2,048 rays have noise of their own, which remains in metrics that are not debiased.
            EXPECT_NEAR(*limited_measures(cell).at(metric).value,
                        *limited_measures(many.cells[i]).at(metric).value, 2 * half_width + 1e-3)
                << cell.id << " " << metric;
        }
    }
    for (const ViewRecord& view : few.views) {
        EXPECT_TRUE(view.halves && view.final_answer);
        EXPECT_EQ(view.score_error, goal.error);
        EXPECT_LT(view.truth_rays, many.views.front().truth_rays);
        EXPECT_THAT(view.truth_command, HasSubstr("--halves"));
    }
}

TEST(ScoreGoal, PrintsItsPageOnceAndWritesItTwice) {
    const auto folder = output_dir();
    const auto run = run_aoscore(kScore, folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "page/index.html\n");
    EXPECT_THAT(read_file(folder / "page/index.html"), ::testing::Not(HasSubstr("first answer")));
}

TEST(ScoreGoal, LeavesAPageAloneThatWouldNotChange) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore(kScore, folder).exit_code, 0);
    const auto written = std::filesystem::last_write_time(folder / "page/index.html");
    ASSERT_EQ(run_aoscore(kScore, folder).exit_code, 0);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "page/index.html"), written);
    EXPECT_EQ(read_results(folder / "page").work.rays, 0U);
    ASSERT_EQ(run_aoscore(std::string(kScore) + " --preset default --filter none", folder).exit_code, 0);
    EXPECT_NE(std::filesystem::last_write_time(folder / "page/index.html"), written);
}

TEST(ScoreGoal, ThatNobodyCanReachSaysWhatWouldBeInReach) {
    const auto run =
        run_aoscore("score pillar --size 16x12 --methods gtao --score-error 1e-6 --out page", output_dir());
    EXPECT_EQ(run.exit_code, 64);
    EXPECT_THAT(run.err, HasSubstr("rays a pixel"));
    EXPECT_THAT(run.err, HasSubstr("--score-error"));
    EXPECT_THAT(run.err, HasSubstr("or more on this view"));
}

TEST(ScoreGoal, GoesWithNoOtherWayToNameRays) {
    for (const char* other : {" --samples 8", " --error 0.01"})
        EXPECT_EQ(run_aoscore(std::string(kScore) + " --score-error 0.01" + other, output_dir()).exit_code,
                  64);
}

// The truth that a method claims to approximate gives the same error when it is traced by itself with many
// rays.
TEST(OwnTruths, AreTracedApartWithAsFewRaysAsTheirRmseNeeds) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore("run hussain-table-5 --scale 0.08 --out page", folder).exit_code, 0);
    std::size_t kept = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder / "truth-cache"))
        kept += file.path().extension() == ".truth";
    EXPECT_EQ(kept, 2U) << "the halves of the ranking's truth alone";
    const Results results = read_results(folder / "page");
    const ViewRecord& view = results.views.at(0);
    ASSERT_EQ(view.truths.size(), 4U);
    for (const TruthRecord& truth : view.truths) {
        EXPECT_EQ(truth.channel.empty(), truth.id != kRankedTruth);
        if (truth.id == kRankedTruth) continue;
        EXPECT_LE(truth.samples, view.samples) << truth.id;
    }
    const CellRecord& cell = results.cells.at(0);
    ASSERT_EQ(cell.own_truth, "binary-0.391");
    const std::string alone =
        fmt::format("reference {} --view {} --size {}x{} --radius 0.391 --samples 1024 --out own.exr",
                    view.scene, view.view, view.width, view.height);
    ASSERT_EQ(run_aoscore(alone, folder).exit_code, 0);
    ASSERT_EQ(
        run_aoscore("compare own.exr page/" + cell.image_file + " --export scores.json", folder).exit_code,
        0);
    const auto scores = nlohmann::json::parse(read_file(folder / "scores.json"));
    EXPECT_NEAR(*cell.own.at(kRankingMetric).value,
                scores.at("metrics").at(kRankingMetric).at("value").get<double>(), 2 * ScoreGoal().error);
    // As many rays as the RMSE needs may not tell other metrics: what is not told says so.
    const MeasuredMetric& structure = cell.own.at(kStructureMetric);
    EXPECT_TRUE(structure.value || structure.note.find("unsure") != std::string::npos) << structure.note;
}

TEST(HalvedTruth, IsTheSameForAnyNumberOfThreads) {
    const auto folder = output_dir();
    std::string first;
    for (const char* threads : {"1", "2"}) {
        const auto run = run_aoscore(
            std::string(
                "reference pillar --size 64x48 --samples 16 --halves --no-cache --out x.exr --threads ") +
                threads,
            folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        ASSERT_EQ(
            run_aoscore("compare x.exr x.exr --json " + std::string(threads) + ".json", folder).exit_code, 0);
        if (first.empty()) {
            std::filesystem::rename(folder / "x.exr", folder / "first.exr");
            first = "first.exr";
        }
    }
    const auto run = run_aoscore("compare first.exr x.exr --fail 'max_error>0'", folder);
    EXPECT_EQ(run.exit_code, 0) << run.out;
}

}  // namespace
}  // namespace aoscore
