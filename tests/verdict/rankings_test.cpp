#include "verdict/rankings.h"

#include "metrics/roles.h"
#include "results/sweep_rows.h"
#include "verdict/baseline.h"

#include <gtest/gtest.h>

#include <algorithm>
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

ViewRecord view(const std::string& key, double radius_m = 0.5, int width = 80) {
    ViewRecord record;
    record.key = key;
    record.radius_m = radius_m;
    record.width = width;
    return record;
}

CellRecord with_preset(CellRecord record, const std::string& preset) {
    record.preset = preset;
    record.id += "/" + preset;
    return record;
}

std::string rank_of(const RankingRecord& ranking, const std::string& method) {
    return rank_text(*std::ranges::find(ranking.places, method, &PlaceRecord::method));
}

TEST(Rankings, PutTheClosestFirstAndSayWhatCannotBeToldApart) {
    const std::vector<CellRecord> cells{cell("v", "far", 0.2, 0.3), cell("v", "twin", 0.1001, 0.5, 2),
                                        cell("v", "near", 0.1, 0.5, 3), failed("v", "broken")};
    const auto rankings = rank({view("v")}, cells, 1);
    ASSERT_EQ(rankings.size(), 1U);
    const std::vector<PlaceRecord>& places = rankings[0].places;
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(rankings[0].metric, "rmse_debiased");
    EXPECT_EQ(places[2].method, "far");
    EXPECT_EQ(rank_text(places[0]), "1–2");
    EXPECT_EQ(rank_text(places[1]), "1–2");
    EXPECT_EQ(rank_text(places[2]), "3");
    EXPECT_EQ(places[0].ties, std::vector<std::size_t>{1});
    EXPECT_EQ(places[1].ties, std::vector<std::size_t>{0});
    EXPECT_TRUE(places[2].ties.empty());
    EXPECT_FALSE(places[0].behind_first);
    EXPECT_GT(places[2].behind_first->low, 0.05);
    for (const PlaceRecord& place : places) {
        EXPECT_LE(place.interval->low, place.value);
        EXPECT_GE(place.interval->high, place.value);
    }
}

TEST(Rankings, CompareAllThatWasDrawnOnAViewWhateverItsPreset) {
    const std::vector<CellRecord> cells{cell("v", "best", 0.1, 0.3), cell("v", "worst", 0.3, 0.3),
                                        with_preset(cell("v", "alone", 0.2, 0.3), "thin"),
                                        with_preset(cell("v", "best", 0.25, 0.3), "thin")};
    const auto rankings = rank({view("v")}, cells, 1);
    ASSERT_EQ(rankings.size(), 1U) << "a preset is no group of its own";
    std::vector<std::string> order;
    for (const PlaceRecord& place : rankings[0].places) order.push_back(place.method + "/" + place.preset);
    EXPECT_EQ(order, (std::vector<std::string>{"best/default", "alone/thin", "best/thin", "worst/default"}));
    EXPECT_EQ(rank_text(rankings[0].places[1]), "2") << "alone in its preset, it wins nothing";
}

TEST(Rankings, GiveABoundAPlaceButNoRank) {
    std::vector<CellRecord> cells{cell("v", "bound", 0.05, 0.3), cell("v", "first", 0.1, 0.3),
                                  cell("v", "second", 0.2, 0.3)};
    cells[0].role = kBoundRole;
    const auto rankings = rank({view("v")}, cells, 1);
    const std::vector<PlaceRecord>& places = rankings.at(0).places;
    EXPECT_EQ(rank_text(places[0]), "bound");
    EXPECT_FALSE(places[0].rank || places[0].behind_first);
    EXPECT_EQ(rank_text(places[1]), "1");
    EXPECT_EQ(rank_text(places[2]), "2");
    EXPECT_FALSE(places[1].behind_first);
    EXPECT_NEAR(places[2].behind_first->low, 0.1, 0.02) << "behind the first that has a rank";
}

TEST(Rankings, OfOneMethodAndOfEqualOnesHaveTheOnlyRanksThereAre) {
    EXPECT_EQ(rank_of(rank({view("v")}, {cell("v", "only", 0.1, 0.3)}, 1).at(0), "only"), "1");
    const auto equal =
        rank({view("v")}, {cell("v", "a", 0.1, 0.3), cell("v", "b", 0.1, 0.3), cell("v", "c", 0.1, 0.3)}, 1);
    for (const char* method : {"a", "b", "c"}) EXPECT_EQ(rank_of(equal.at(0), method), "1–3") << method;
    EXPECT_TRUE(rank({view("v")}, {failed("v", "broken")}, 1).empty());
}

TEST(Rankings, OverSeveralViewsTakeTheRootMeanSquareOfMethodsThatSucceededOnAll) {
    const std::vector<CellRecord> cells{cell("a", "m", 0.1, 0.1),     cell("b", "m", 0.3, 0.1),
                                        cell("a", "n", 0.15, 0.1, 2), cell("b", "n", 0.35, 0.1, 2),
                                        cell("a", "once", 0.05, 0.1), failed("b", "once")};
    const auto rankings = rank({view("a"), view("b")}, cells, 1);
    ASSERT_EQ(rankings.size(), 3U);
    const RankingRecord& over_views = rankings.back();
    EXPECT_EQ(over_views.view_keys, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(over_views.radius_m, 0.5);
    ASSERT_EQ(over_views.places.size(), 2U);
    EXPECT_EQ(over_views.places[0].method, "m");
    EXPECT_EQ(over_views.places[0].cell_ids, (std::vector<std::string>{"a/m/default", "b/m/default"}));
    EXPECT_NEAR(over_views.places[0].value, std::sqrt((0.1 * 0.1 + 0.3 * 0.3) / 2), 0.01);
    EXPECT_EQ(over_views.places[0].measures.at("rmse_debiased").value, over_views.places[0].value);
    EXPECT_LT(over_views.places[0].interval->low, 0.12) << "views are resampled too";
    EXPECT_EQ(rank_text(over_views.places[1]), "2") << "views draw alike for both, so their difference stays";
}

TEST(Rankings, HaveTheNumbersOverViewsThatSweepsHave) {
    Results results;
    results.views = {view("a"), view("b")};
    results.cells = {cell("a", "m", 0.1, 0.1), cell("b", "m", 0.3, 0.1), cell("a", "n", 0.19, 0.1, 2),
                     cell("b", "n", 0.22, 0.1, 2)};
    for (CellRecord& one : results.cells) one.ranked[kBiasMetric].value = one.view_key == "a" ? -0.05 : 0.15;
    SweepRecord sweep;
    for (const CellRecord& one : results.cells) sweep.points.push_back({one.id, {{"method", one.method}}});
    const std::vector<SweepRow> rows = sweep_rows(results, sweep);
    const std::vector<SweepRowsOverViews> over_views = rows_over_views(rows);
    ASSERT_EQ(over_views.size(), 1U);
    const RankingRecord ranking = rank(results.views, results.cells, 1).back();
    ASSERT_EQ(ranking.places.size(), over_views[0].rows.size());
    EXPECT_EQ(ranking.places[0].method, "n") << "as a root mean square; as an arithmetic mean m would lead";
    for (const PlaceRecord& place : ranking.places) {
        const auto row = std::ranges::find_if(
            over_views[0].rows, [&](const SweepRow& r) { return r.cell->method == place.method; });
        ASSERT_NE(row, over_views[0].rows.end());
        EXPECT_EQ(row->error, place.value);
        EXPECT_EQ(row->noisy_error, place.measures.at(kNoisyRankingMetric).value);
        EXPECT_DOUBLE_EQ(*row->bias, 0.05);
        EXPECT_EQ(row->bias, place.measures.at(kBiasMetric).value);
    }
}

TEST(Rankings, AreByRmseWhereTheDebiasedOneIsMissing) {
    std::vector<CellRecord> cells{cell("v", "m", 0.1, 0.3), cell("v", "n", 0.2, 0.3)};
    cells[1].ranked.erase("rmse_debiased");
    EXPECT_EQ(rank({view("v")}, cells, 1).at(0).metric, "rmse");
}

TEST(Rankings, DoNotMixViewsOfDifferentRadiiOrSizes) {
    std::vector<CellRecord> cells;
    for (const char* key : {"near", "far", "near again", "small", "alone"}) {
        cells.push_back(cell(key, "m", 0.1, 0.3));
        cells.push_back(cell(key, "n", 0.2, 0.3));
    }
    const auto rankings = rank({view("near", 0.05), view("far", 0.0177), view("near again", 0.05),
                                view("small", 0.05, 40), view("alone", 1)},
                               cells, 1);
    ASSERT_EQ(rankings.size(), 6U) << "one a view, and one over the two that are alike";
    EXPECT_EQ(rankings.back().view_keys, (std::vector<std::string>{"near", "near again"}));
    EXPECT_EQ(rankings.back().radius_m, 0.05);
}

TEST(Rankings, OfCellsWithoutAnythingToResampleTellNothingApart) {
    std::vector<CellRecord> cells{cell("v", "m", 0.1, 0.3), cell("v", "n", 0.2, 0.3)};
    for (CellRecord& record : cells) record.analysis->blocks = {};
    const auto rankings = rank({view("v")}, cells, 1);
    EXPECT_EQ(rank_of(rankings.at(0), "m"), "1–2");
    EXPECT_EQ(rank_of(rankings.at(0), "n"), "1–2");
}

Results results_of(const std::vector<CellRecord>& cells) {
    Results results;
    results.seed = 1;
    results.views = {view("v")};
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

TEST(Baseline, AsksMoreOfOneChangeTheMoreAreHeldAgainstIt) {
    const auto width_of = [](int others) {
        std::vector<CellRecord> old{cell("v", "m", 0.1, 0.3, 1)}, now{cell("v", "m", 0.1, 0.3, 2)};
        for (int i = 0; i < others; ++i) {
            const std::string name = "other " + std::to_string(i);
            const auto seed = static_cast<unsigned>(10 + i);
            old.push_back(cell("v", name, 0.1, 0.3, seed));
            now.push_back(cell("v", name, 0.1, 0.3, seed + 100));
        }
        const BaselineRecord record = against_baseline(results_of(now), results_of(old));
        return record.changes[0].change->high - record.changes[0].change->low;
    };
    const double alone = width_of(0), among_twenty = width_of(19);
    // The largest of 20 normal numbers lies within 3.02, that of one within 1.96, each in 95 of 100 cases.
    EXPECT_NEAR(among_twenty / alone, 3.02 / 1.96, 0.12);
}

TEST(Baseline, SaysThatAnotherRayTracerMadeItsTruths) {
    const Results before = results_of({cell("v", "m", 0.2, 0.3)});
    Results now = before;
    EXPECT_EQ(other_truths(now, before), "");
    now.views[0].integrator = "another";
    EXPECT_NE(other_truths(now, before), "");
}

TEST(Baseline, DoesNotCompareFewRaysThatAreNotInHalvesWithOtherNumbersOfRays) {
    Results before = results_of({cell("v", "m", 0.2, 0.3)});
    Results now = before;
    before.views[0].samples = 16;
    now.views[0].samples = 48;
    now.views[0].halves = true;
    EXPECT_EQ(against_baseline(now, before).changes[0].verdict, "not comparable");
    EXPECT_EQ(against_baseline(before, now).changes[0].verdict, "not comparable");
    before.views[0].halves = true;
    EXPECT_EQ(against_baseline(now, before).changes[0].verdict, "same");
    now.views[0].halves = before.views[0].halves = false;
    now.views[0].samples = 256;
    before.views[0].samples = 64;
    EXPECT_EQ(against_baseline(now, before).changes[0].verdict, "same");
    now.views[0].samples = before.views[0].samples = 16;
    EXPECT_EQ(against_baseline(now, before).changes[0].verdict, "same");
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
