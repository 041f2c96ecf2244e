#include "experiment/rankings.h"

#include "experiment/baseline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace aoscore {
namespace {

/// A cell whose squared errors scatter about error^2 from block to block.
CellRecord cell(const std::string& view, const std::string& method, double error, double scatter,
                unsigned seed = 1) {
    CellRecord record;
    record.id = view + "/" + method + "/default";
    record.view_key = view;
    record.method = method;
    record.preset = "default";
    record.filter = "none";
    ErrorAnalysis& analysis = record.analysis.emplace();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> factor(1 - scatter, 1 + scatter);
    double sum = 0;
    for (int i = 0; i < 100; ++i) {
        analysis.blocks.counts.push_back(64);
        analysis.blocks.squared_sums.push_back(64 * error * error * factor(random));
        analysis.blocks.variance_sums.push_back(0);
        sum += analysis.blocks.squared_sums.back();
    }
    analysis.blocks.absolute_sums = analysis.blocks.signed_sums = analysis.blocks.counts;
    const double rmse = std::sqrt(sum / 6400);
    record.ranked = {{"rmse", {rmse, ""}}, {"rmse_debiased", {rmse, ""}}};
    return record;
}

CellRecord failed(const std::string& view, const std::string& method) {
    CellRecord record = cell(view, method, 0.1, 0);
    record.analysis.reset();
    record.ranked.clear();
    record.error = "7 pixels are NaN or infinite";
    return record;
}

TEST(Rankings, PutTheClosestFirstAndDeclareTies) {
    const std::vector<CellRecord> cells{cell("v", "far", 0.2, 0.3), cell("v", "twin", 0.1001, 0.5, 2),
                                        cell("v", "near", 0.1, 0.5, 3), failed("v", "broken")};
    const auto rankings = rank(cells, 1);
    ASSERT_EQ(rankings.size(), 1U);
    const std::vector<PlaceRecord>& places = rankings[0].places;
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(rankings[0].metric, "rmse_debiased");
    EXPECT_EQ(places[2].method, "far");
    EXPECT_EQ(places[0].rank, 1);
    EXPECT_EQ(places[1].rank, 1) << "a tie shares its rank";
    EXPECT_EQ(places[2].rank, 3);
    EXPECT_EQ(places[0].ties, std::vector<std::size_t>{1});
    EXPECT_EQ(places[1].ties, std::vector<std::size_t>{0});
    EXPECT_TRUE(places[2].ties.empty());
    EXPECT_GT(places[2].behind_best.low, 0.05);
    for (const PlaceRecord& place : places) {
        EXPECT_LE(place.interval.low, place.value);
        EXPECT_GE(place.interval.high, place.value);
    }
}

TEST(Rankings, OverSeveralViewsTakeTheMeanOfMethodsThatSucceededOnAll) {
    const std::vector<CellRecord> cells{cell("a", "m", 0.1, 0.1),     cell("b", "m", 0.3, 0.1),
                                        cell("a", "n", 0.15, 0.1, 2), cell("b", "n", 0.35, 0.1, 2),
                                        cell("a", "once", 0.05, 0.1), failed("b", "once")};
    const auto rankings = rank(cells, 1);
    ASSERT_EQ(rankings.size(), 3U);
    const RankingRecord& over_views = rankings.back();
    EXPECT_EQ(over_views.view_keys, (std::vector<std::string>{"a", "b"}));
    ASSERT_EQ(over_views.places.size(), 2U);
    EXPECT_EQ(over_views.places[0].method, "m");
    EXPECT_EQ(over_views.places[0].cell_ids, (std::vector<std::string>{"a/m/default", "b/m/default"}));
    EXPECT_NEAR(over_views.places[0].value, 0.2, 0.01);
    EXPECT_LT(over_views.places[0].interval.low, 0.12) << "views are resampled too";
    EXPECT_EQ(over_views.places[1].rank, 2) << "views draw alike for both, so their difference stays";
}

Results results_of(const std::vector<CellRecord>& cells) {
    Results results;
    results.seed = 1;
    ViewRecord view;
    view.key = "v";
    view.width = 80;
    results.views = {view};
    results.cells = cells;
    return results;
}

TEST(Baseline, TellsBetterWorseSameAndWhatCannotBeCompared) {
    const Results before =
        results_of({cell("v", "better", 0.2, 0.3), cell("v", "worse", 0.1, 0.3), cell("v", "same", 0.1, 0.3),
                    cell("v", "breaks", 0.1, 0.3), failed("v", "mended")});
    const Results now = results_of({cell("v", "better", 0.1, 0.3), cell("v", "worse", 0.2, 0.3),
                                    cell("v", "same", 0.1005, 0.3, 7), failed("v", "breaks"),
                                    cell("v", "mended", 0.1, 0.3), cell("v", "new", 0.1, 0.3)});
    const BaselineRecord record = against_baseline(now, before);
    std::vector<std::string> verdicts;
    for (const ChangeRecord& change : record.changes) verdicts.push_back(change.verdict);
    EXPECT_EQ(verdicts, (std::vector<std::string>{"better", "worse", "same", "worse", "not comparable",
                                                  "not comparable"}));
    EXPECT_LT(record.changes[0].change->high, 0);
    EXPECT_GT(record.changes[1].change->low, 0);
    EXPECT_EQ(record.changes[5].reason, "not in the earlier run");
}

TEST(Baseline, DoesNotCompareWhatShowsSomethingElse) {
    const Results before = results_of({cell("v", "m", 0.2, 0.3)});
    Results now = before;
    now.views[0].radius_m = 2;
    EXPECT_EQ(against_baseline(now, before).changes[0].reason, "the radius has changed");
    now = before;
    now.views[0].width = 90;
    EXPECT_EQ(against_baseline(now, before).changes[0].reason, "the images differ in size");
    now = before;
    now.cells[0].analysis->blocks.counts[3] = 1;
    EXPECT_EQ(against_baseline(now, before).changes[0].reason, "other pixels are valid");
}

}  // namespace
}  // namespace aoscore
