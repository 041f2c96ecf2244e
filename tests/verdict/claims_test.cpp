#include "core/error.h"
#include "core/files.h"
#include "plan/claims/quantity.h"
#include "plan/claims/time_quantities.h"
#include "plan/resolved_cell.h"
#include "support/support.h"
#include "verdict/claim_verdicts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A list with one claim of one check on cells "a" (alchemy), "c" (crytek-ssao) and a sweep of samples "s".
class Claims : public ::testing::Test {
  protected:
    /// Writes the file and loads it as the program does.
    static ClaimList loaded(const json& file) {
        const auto folder = testing::output_dir() / "claims";
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "test.json") << file;
        return load_claims(folder).front();
    }

    static json file_of(json check, const json& size = {64, 48}) {
        json file = {
            {"id", "test"},
            {"source", {{"author", "A"}, {"title", "T"}, {"year", 2020}}},
            {"views",
             {{"v",
               {{"scene", "wall"}, {"view", "facing"}, {"size", size}, {"samples", 8}, {"radius_m", 1}}}}},
            {"cells",
             {{"a", {{"view", "v"}, {"method", "alchemy"}}},
              {"c", {{"view", "v"}, {"method", "crytek-ssao"}}},
              {"s", {{"like", "a"}, {"vary", {{"samples", {4, 8, 16}}}}}}}},
            {"claims", json::array({{{"id", "T01"}, {"place", "p"}, {"claim", "c"}}})}};
        if (check.is_string())
            file["claims"][0]["cannot"] = check;
        else
            file["claims"][0]["checks"] = json::array({std::move(check)});
        return file;
    }

    static ClaimList list_of(json check, const json& size = {64, 48}) {
        return loaded(file_of(std::move(check), size));
    }

    /// A list of one claim that cites "a" of these sources.
    static json citing(json sources) {
        json file = file_of("it needs frames");
        file.erase("source");
        file["sources"] = std::move(sources);
        file["claims"][0]["source"] = "a";
        return file;
    }

    /// Results in which every planned cell has these times and this bias.
    static Results results_of(const ClaimList& list, const std::map<std::string, std::vector<double>>& ms) {
        ExperimentPlan plan;
        plan_claims(plan, {list});
        Results results;
        ViewRecord view;
        view.key = "wall/facing";
        view.scene = "wall";
        view.view = "facing";
        view.width = 64;
        view.height = 48;
        view.radius_m = 1;
        results.views.push_back(view);
        for (const CellPlan& cell : plan.views.at(0).cells) {
            CellRecord record;
            record.id = view.key + "/" + cell_name(cell);
            record.view_key = view.key;
            record.method = record.method_label = cell.method;
            const auto found = ms.find(cell_name(cell));
            if (found == ms.end()) continue;
            record.ao.processor_runs_ms = found->second;
            record.fetches_per_pixel = found->second.front();
            results.cells.push_back(std::move(record));
        }
        return results;
    }

    std::string verdict(const json& check, const std::map<std::string, std::vector<double>>& ms) const {
        const ClaimList list = list_of(check);
        return judge_claims({list}, results_of(list, ms)).at(0).verdict;
    }

    static json order() { return {{"kind", "order"}, {"quantity", "ao_ms"}, {"cells", {"a", "c"}}}; }
};

const std::vector<double> kFive(10, 5.0), kSix(10, 6.0), kWild{4, 8, 5, 9, 3, 7, 4.5, 8.5, 5.5, 6};

TEST_F(Claims, AreMeasuredInPicturesOfASizeThatThereIs) {
    for (const json& size : {json{12.7, 48}, json{64, -3}, json{1e12, 48}}) {
        try {
            list_of("no reason", size);
            ADD_FAILURE() << size;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::file_error);
            EXPECT_THAT(e.what(), HasSubstr("test.json: views.v.size"));
            EXPECT_THAT(e.what(), HasSubstr("whole pixels"));
        }
    }
}

TEST_F(Claims, AnOrderHoldsFailsOrCannotBeTold) {
    EXPECT_EQ(verdict(order(), {{"alchemy/default", kFive}, {"crytek-ssao/default", kSix}}),
              ClaimRecord::kHolds);
    EXPECT_EQ(verdict(order(), {{"alchemy/default", kSix}, {"crytek-ssao/default", kFive}}),
              ClaimRecord::kFails);
    EXPECT_EQ(verdict(order(), {{"alchemy/default", kFive}, {"crytek-ssao/default", kFive}}),
              ClaimRecord::kCannotTell)
        << "another load could have turned them round";
    json fetches = order();
    fetches["quantity"] = "fetches";
    EXPECT_EQ(verdict(fetches, {{"alchemy/default", kFive}, {"crytek-ssao/default", kFive}}),
              ClaimRecord::kFails)
        << "what is equal is not less";
    EXPECT_EQ(verdict(order(), {{"alchemy/default", kFive}, {"crytek-ssao/default", kWild}}),
              ClaimRecord::kCannotTell);
}

TEST_F(Claims, AreDecidedOnlyWhereAllValuesOfAnOpenConstantAgree) {
    json file = file_of(order());
    file["open_constants"]["n"] = {{"why", "nobody prints the samples"},
                                   {"settings",
                                    {{{"about", "4 samples"}, {"cells", {{"c", {{"samples", 4}}}}}},
                                     {{"about", "8 samples"}, {"cells", {{"c", {{"samples", 8}}}}}}}}};
    file["claims"][0]["over"] = "n";
    const ClaimList list = loaded(file);
    const auto judged = [&](const std::vector<double>& four, const std::vector<double>& eight) {
        return judge_claims({list}, results_of(list, {{"alchemy/default", kFive},
                                                      {"crytek-ssao/default/samples=4", four},
                                                      {"crytek-ssao/default/samples=8", eight}}))
            .at(0);
    };
    EXPECT_EQ(judged(kSix, kSix).verdict, ClaimRecord::kHolds);
    const std::vector<double> four(10, 4.0);
    EXPECT_EQ(judged(four, four).verdict, ClaimRecord::kFails);
    const ClaimRecord turns = judged(four, kSix);
    EXPECT_EQ(turns.verdict, ClaimRecord::kCannotTell);
    for (const char* part : {"nobody prints the samples", "it holds at 1 of 2 settings (8 samples)",
                             "it does not hold at 1 of 2 settings (4 samples)"})
        EXPECT_THAT(turns.reason, HasSubstr(part));
}

TEST_F(Claims, AConstantOfTheFilterCanBeLeftOpenToo) {
    json file = file_of(order());
    file["cells"]["a"]["filter"] = "gaussian-depth";
    file["open_constants"]["s"] = {
        {"why", "nobody prints the strength"},
        {"settings", {{{"about", "2"}, {"cells", {{"a", {{"filter.strength", 2}}}}}}}}};
    file["claims"][0]["over"] = "s";
    const CellPlan& cell = loaded(file).claims.at(0).settings.at(0).checks.at(0).cells.at(0).plan;
    EXPECT_EQ(cell.filter_overrides.at("strength"), ParameterValue(2));
    EXPECT_TRUE(cell.overrides.empty());
}

TEST_F(Claims, WhatWasNotMeasuredCannotBeToldAndIsNamed) {
    const ClaimList list = list_of(order());
    const ClaimRecord record = judge_claims({list}, results_of(list, {{"alchemy/default", kFive}})).at(0);
    EXPECT_EQ(record.verdict, ClaimRecord::kCannotTell);
    EXPECT_THAT(record.reason, HasSubstr("crytek-ssao/default"));
    const ClaimList reasoned = list_of("it needs frames");
    EXPECT_EQ(judge_claims({reasoned}, Results()).at(0).reason, "it needs frames");
}

TEST_F(Claims, RatiosSlopesSpreadsAndGainsAreWhatTheyAreCalled) {
    const std::map<std::string, std::vector<double>> ms{
        {"alchemy/default/samples=4", std::vector<double>(8, 4.0)},
        {"alchemy/default/samples=8", std::vector<double>(8, 8.0)},
        {"alchemy/default/samples=16", std::vector<double>(8, 16.0)},
        {"alchemy/default", kSix},
        {"crytek-ssao/default", std::vector<double>(8, 3.0)}};
    const auto value = [&](json check) {
        check["quantity"] = "ao_ms";
        check["low"] = 0;
        const ClaimList list = list_of(check);
        return *judge_claims({list}, results_of(list, ms)).at(0).findings.at(0).value;
    };
    EXPECT_DOUBLE_EQ(value({{"kind", "ratio"}, {"cells", {"a", "c"}}}), 2.0);
    EXPECT_DOUBLE_EQ(value({{"kind", "difference"}, {"cells", {"a", "c"}}}), 3.0);
    EXPECT_NEAR(value({{"kind", "slope"}, {"cells", {"s"}}}), 1.0, 1e-12);
    EXPECT_NEAR(value({{"kind", "spread"}, {"cells", {"s"}}}), 12 / (28.0 / 3), 1e-12);
    EXPECT_DOUBLE_EQ(value({{"kind", "ratio_difference"}, {"cells", {"s", "a"}}}), 0.5 - 16.0 / 6);
    EXPECT_DOUBLE_EQ(value({{"kind", "gain"}, {"cells", {"s", "a"}}}), (16.0 - 6) / (4.0 - 8));
}

// "s" costs 4, 8 and 16 ms and reads as many texels: between two of them the fetches follow the logarithm.
TEST_F(Claims, AtEqualCostAnInterpolatedRivalIsTakenOff) {
    std::map<std::string, std::vector<double>> ms{
        {"alchemy/default/samples=4", std::vector<double>(8, 4.0)},
        {"alchemy/default/samples=8", std::vector<double>(8, 8.0)},
        {"alchemy/default/samples=16", std::vector<double>(8, 16.0)}};
    const auto finding = [&](double cost) {
        ms["alchemy/default"] = std::vector<double>(8, cost);
        const ClaimList list = list_of({{"kind", "at_equal_cost"},
                                        {"quantity", "fetches"},
                                        {"cost", "ao_ms"},
                                        {"low", 0},
                                        {"cells", {"a", "s"}}});
        const ClaimRecord record = judge_claims({list}, results_of(list, ms)).at(0);
        return record.findings.empty() ? std::nullopt : record.findings.front().value;
    };
    EXPECT_NEAR(finding(8 * std::sqrt(2.0)).value(), 8 * std::sqrt(2.0) - 12, 1e-9);
    EXPECT_NEAR(finding(8).value(), 0, 1e-9);
    EXPECT_NEAR(finding(40).value(), 24, 1e-9) << "the dearest rival has no more to give";
    EXPECT_NEAR(finding(3).value(), -1, 1e-9) << "no rival is as cheap: the cheapest stands for all";
    EXPECT_THROW(
        list_of({{"kind", "at_equal_cost"}, {"quantity", "fetches"}, {"low", 0}, {"cells", {"a", "s"}}}),
        Error)
        << "which cost is equal?";
}

// Every block has the same error, so that no draw of blocks can change it.
TEST_F(Claims, AnErrorThatIsEvenOverThePictureHasNoUncertainty) {
    CellRecord cell;
    cell.analysis.emplace();
    cell.analysis->fit.rmse = std::sqrt(0.05);
    cell.analysis->fit.rmse_debiased = std::sqrt(0.04);
    cell.analysis->fit.squared_sums = {0.5, 1, 0.25};
    cell.analysis->blocks.counts = {10, 20, 5};
    cell.analysis->behind_edges = {{4, 2, 0}, {-1, -0.5, 0}};
    cell.repeats.emplace();
    cell.repeats->hidden_angles["cone_angle"] = {{3, 6}, {30, 60}, {-15, -30}};
    const auto measured = [&](const char* id) {
        const Measured value = find_quantity(id, "test").measure(cell, {}, 1);
        const Measured::Range range = value.range().value();
        EXPECT_NEAR(range.low, *value.value, 1e-12) << id;
        EXPECT_NEAR(range.high, *value.value, 1e-12) << id;
        EXPECT_GT(value.draws.size(), 100U) << id;
        return *value.value;
    };
    EXPECT_NEAR(measured("fitted_rmse"), 0.2, 1e-12);
    EXPECT_NEAR(measured("hidden_cone_error"), 10, 1e-12);
    EXPECT_NEAR(measured("hidden_cone_bias"), -5, 1e-12);
    cell.analysis->behind_edges = {{4, 2, 2}, {-1, -0.5, -0.5}};
    EXPECT_NEAR(measured("behind_edges"), -0.25, 1e-12);
    cell.analysis->fit.squared_sums = {1.5, 0, 0.25};
    const Measured uneven = find_quantity("fitted_rmse", "test").measure(cell, {}, 1);
    EXPECT_LT(uneven.range()->low, 0.2);
    EXPECT_GT(uneven.range()->high, 0.2);
}

TEST_F(Claims, AListMustBeUnderstoodWhole) {
    for (const auto& [key, value] : std::vector<std::pair<std::string, json>>{{"kind", "bigger"},
                                                                              {"quantity", "speed"},
                                                                              {"cells", {"nobody"}},
                                                                              {"cells", {"a"}},
                                                                              {"wrong", 1}}) {
        json bad = order();
        bad[key] = value;
        EXPECT_THROW(list_of(bad), Error) << key;
    }
    EXPECT_THROW(list_of({{"kind", "ratio"}, {"quantity", "ao_ms"}, {"cells", {"a", "c"}}}), Error)
        << "no range";
}

TEST_F(Claims, EveryClaimCitesItsOwnSource) {
    const json page = {{"author", "A"}, {"title", "T"}, {"version", "6.7"}};
    const json readme = {{"repository", "o/r"}, {"document", "README.md"}, {"year", 2024}};
    json file = citing({{"a", page}, {"b", readme}});
    file["claims"].push_back(
        {{"id", "T02"}, {"source", "b"}, {"place", "p"}, {"claim", "c"}, {"cannot", "x"}});
    const ClaimList list = loaded(file);
    const std::vector<ClaimRecord> records = judge_claims({list}, Results());
    EXPECT_EQ(records.at(0).source, "A, T, 6.7");
    EXPECT_EQ(records.at(1).source, "o/r, README.md, 2024");
    EXPECT_THAT(verdict_text(records.at(1)),
                HasSubstr("T02 cannot be told here: c (o/r, README.md, 2024, p)"));
}

TEST_F(Claims, ASourceThatNobodyCouldFindIsRefused) {
    const json good = {{"author", "A"}, {"title", "T"}, {"year", 2024}};
    EXPECT_NO_THROW(loaded(citing({{"a", good}})));
    EXPECT_THROW(loaded(citing({{"b", good}})), Error) << "the claim's is not there";
    EXPECT_THROW(loaded(citing({{"a", good}, {"b", good}})), Error) << "cited by no claim";
    EXPECT_THROW(loaded(citing({{"a", {{"author", "A"}, {"title", "T"}}}})), Error)
        << "neither year nor version";
    EXPECT_THROW(loaded(citing({{"a", {{"repository", "o/r"}, {"year", 2024}}}})), Error) << "no document";
    EXPECT_THROW(loaded(citing(json::object())), Error) << "none at all";
    json both = citing({{"a", good}});
    both["source"] = good;
    EXPECT_THROW(loaded(both), Error) << "one for all, and several";
    json none = citing({{"a", good}});
    none["claims"][0].erase("source");
    EXPECT_THROW(loaded(none), Error) << "the claim names none";
}

TEST_F(Claims, AListIsChosenByItsIdAndAClaimByItsOwn) {
    const auto count = [&](const std::vector<std::string>& ids) {
        std::size_t sum = 0;
        for (const ClaimList& list : chosen_claims(load_claims(), ids)) sum += list.claims.size();
        return sum;
    };
    std::size_t field = 0;
    for (const ClaimList& list : load_claims()) {
        if (list.id == "field") field = list.claims.size();
    }
    EXPECT_EQ(count({"field"}), field);
    EXPECT_EQ(count({"field", "H01"}), field + 1);
    EXPECT_EQ(count({"H01"}), 1u);
    EXPECT_THROW(count({"fields"}), Error);
}

TEST_F(Claims, NothingIsTimedLitOrDrawnAsAWholeThatNoQuantityNeeds) {
    const auto planned = [&](const char* quantity) {
        json check = order();
        check["quantity"] = quantity;
        ExperimentPlan plan;
        plan_claims(plan, {list_of(check)});
        return plan.views.at(0);
    };
    EXPECT_FALSE(planned("rmse").cells.at(0).timed || planned("fetches").cells.at(0).timed);
    EXPECT_TRUE(planned("cost_ms").cells.at(0).timed && planned("layers_processor_ms").cells.at(0).timed);
    EXPECT_FALSE(planned("cost_ms").lit);
    EXPECT_TRUE(planned("frame_ms").lit);
    EXPECT_FALSE(planned("frame_ms").cells.at(0).whole_frames);
    EXPECT_TRUE(planned("waiting").lit && planned("waiting").cells.at(0).whole_frames);
}

TEST_F(Claims, CellsAreDrawnAgainAndCausesTracedOnlyForWhatNeedsThem) {
    const auto planned = [&](const char* quantity, const json& signals) {
        json file = file_of(order());
        file["claims"][0]["checks"][0]["quantity"] = quantity;
        for (const char* cell : {"a", "c"}) file["cells"][cell]["signals"] = signals;
        ExperimentPlan plan;
        plan_claims(plan, {loaded(file)});
        return plan.views.at(0);
    };
    const ViewPlan plain = planned("rmse", json::array()), again = planned("noise", json::array());
    const ViewPlan hidden = planned("truth_found", json::array());
    EXPECT_FALSE(plain.extras.causes || plain.cells.at(0).repeats);
    EXPECT_TRUE(!again.extras.causes && again.cells.at(0).repeats);
    EXPECT_TRUE(hidden.extras.causes && hidden.cells.at(0).repeats);
    EXPECT_FALSE(hidden.extras.bent_normals);
    EXPECT_THROW(planned("unconverged", json::array()), Error) << "no cell says what is converged";
    EXPECT_TRUE(planned("rmse", {"cone_angle"}).extras.bent_normals);
    EXPECT_THROW(planned("hidden_cone_error", {"bent_normal"}), Error) << "no cell gives cones";
    EXPECT_THROW(planned("rmse", {"colour"}), Error) << "no signal";
}

// The values of sums that are known, and an interval that is empty only where all blocks are alike.
TEST_F(Claims, WhatRepeatsFindIsAPartOfSums) {
    CellRecord cell;
    cell.repeats.emplace();
    cell.repeats->counts = {50, 50};
    cell.repeats->variance = {0.5, 0.5};
    FoundOcclusion& found = cell.repeats->of_layers.emplace();
    cell.repeats->of_truth.emplace().strength = 3;
    found.hidden = {10, 30};
    found.found = {1, 9};
    found.visible = {40, 40};
    found.kept = {20, 20};
    const auto measured = [&](const char* id) {
        return find_quantity(id, "test").measure(cell, ViewRecord(), 1);
    };
    EXPECT_DOUBLE_EQ(*measured("noise").value, 0.1);
    EXPECT_NEAR(*measured("fitted_noise").value, 0.3, 1e-12);
    EXPECT_DOUBLE_EQ(*measured("layers_found").value, 0.25);
    EXPECT_DOUBLE_EQ(*measured("layers_kept").value, 0.5);
    EXPECT_NEAR(measured("layers_found").range()->low, 0.1, 1e-12) << "the first block alone";
    EXPECT_NEAR(measured("layers_found").range()->high, 0.3, 1e-12) << "the second alone";
    EXPECT_NEAR(measured("layers_kept").range()->low, 0.5, 1e-12);
    EXPECT_FALSE(find_quantity("noise", "test").measure(CellRecord(), ViewRecord(), 1).value);
}

// The AO pass is told without its layers, run by run.
TEST_F(Claims, ThePassIsTimedWithoutItsDepthLayers) {
    CellRecord cell;
    cell.ao.processor_runs_ms = {10, 11, 12};
    const auto measured = [&](const char* id) {
        return find_quantity(id, "test").measure(cell, ViewRecord(), 1).value;
    };
    EXPECT_EQ(measured("ao_processor_ms"), 11);
    cell.layers_processor.runs_ms = {4, 3, 2};
    cell.layers_processor.median_ms = 3;
    EXPECT_EQ(measured("ao_processor_ms"), 8);
    EXPECT_EQ(measured("layers_processor_ms"), 3);
    EXPECT_EQ(measured("ao_ms"), 11);
}

// Of a clock's milliseconds nothing comes into a verdict: they hold what others did meanwhile.
TEST_F(Claims, TimesAreProcessorTimesAndSureOfNoMoreThanALoadLeaves) {
    CellRecord cell;
    cell.ao.runs_ms = {10, 11, 12};
    cell.ao.median_ms = 11;
    const auto measured = [&] { return find_quantity("ao_ms", "test").measure(cell, ViewRecord(), 1); };
    EXPECT_FALSE(measured().value);
    cell.ao.processor_runs_ms = kFive;
    EXPECT_EQ(measured().value, 5);
    const double half_width = 1.96 * time_quantities::kLoadSpread;
    EXPECT_NEAR(measured().range()->low, 5 * std::exp(-half_width), 0.05) << "though all runs were alike";
    EXPECT_NEAR(measured().range()->high, 5 * std::exp(half_width), 0.05);
}

// The machine may be all of it, so that a spread can be small enough, and never proven too large.
TEST_F(Claims, TheSpreadOfRunsIsKnownFromAboveAlone) {
    CellRecord cell;
    cell.ao.processor_runs_ms = kWild;
    const Measured spread = find_quantity("variation", "test").measure(cell, ViewRecord(), 1);
    EXPECT_GT(*spread.value, 0.2);
    EXPECT_EQ(spread.range()->low, 0);
    EXPECT_GE(spread.range()->high, *spread.value);
}

TEST_F(Claims, ACellOfManyDrawsIsTheirMeanOrTheirBest) {
    const auto measured = [&](const char* of_draws) {
        json file = file_of({{"kind", "value"}, {"quantity", "fetches"}, {"low", 0}, {"cells", {"a"}}});
        file["cells"]["a"].update({{"draws", 4}, {"of_draws", of_draws}});
        const ClaimList list = loaded(file);
        const Results results = results_of(list, {{"alchemy/default", {10, 10}},
                                                  {"alchemy/default/draw=1", {12, 12}},
                                                  {"alchemy/default/draw=2", {14, 14}},
                                                  {"alchemy/default/draw=3", {16, 16}}});
        return judge_claims({list}, results).at(0).findings.at(0);
    };
    const ClaimFinding mean = measured("mean"), best = measured("best");
    EXPECT_EQ(mean.value, 13);
    // The standard deviation of the mean of four such numbers is sqrt(5) / 2.
    EXPECT_NEAR(*mean.high - *mean.low, 2 * 1.96 * std::sqrt(5.0) / 2, 0.6);
    EXPECT_EQ(best.value, 10);
    EXPECT_EQ(best.low, best.high);
    EXPECT_THROW(measured("worst"), Error);
}

TEST_F(Claims, ARegionCountsItsOwnBlocksAlone) {
    json file = file_of({{"kind", "value"}, {"quantity", "bias"}, {"low", 0}, {"cells", {"a"}}});
    file["views"]["v"]["region"] = {0, 0, 0.5, 1};
    const ClaimList list = loaded(file);
    Results results = results_of(list, {{"alchemy/default", kFive}});
    BlockErrors& blocks = results.cells.at(0).analysis.emplace().blocks;
    blocks.side_px = 8;
    blocks.across = 8;
    blocks.down = 6;
    for (int i = 0; i < 48; ++i) {
        const bool left = i % 8 < 4;
        blocks.counts.push_back(10);
        blocks.squared_sums.push_back(left ? 2.5 : 0.1);
        blocks.absolute_sums.push_back(left ? 5 : 1);
        blocks.signed_sums.push_back(left ? 5 : -1);
        blocks.missing_counts.push_back(0);
        blocks.false_counts.push_back(0);
    }
    const ClaimFinding finding = judge_claims({list}, results).at(0).findings.at(0);
    EXPECT_DOUBLE_EQ(finding.value.value(), 0.5);
    EXPECT_DOUBLE_EQ(finding.low.value(), 0.5);
    file["claims"][0]["checks"][0]["quantity"] = "ssim";
    EXPECT_THROW(loaded(file), Error) << "it is known over the whole picture alone";
    file["views"]["v"]["region"] = {0.5, 0, 0.5, 1};
    EXPECT_THROW(loaded(file), Error) << "nothing lies in it";
}

TEST_F(Claims, EveryCellThatTheClaimsAskForCanBeResolved) {
    ExperimentPlan plan;
    plan_claims(plan, load_claims());
    const Registry registry = load_registry();
    for (const ViewPlan& view : plan.views) {
        for (const CellPlan& cell : view.cells)
            EXPECT_NO_THROW(resolve(cell, registry, 1, std::nullopt)) << cell_name(cell);
    }
}

TEST_F(Claims, WhatChangedSinceAnEarlierRunIsToldFromWhatWasNotJudgedOrMeasuredLarger) {
    const auto run = [](std::vector<std::pair<std::string, std::string>> verdicts, int width) {
        Results results;
        for (const auto& [id, verdict] : verdicts) {
            results.claims.emplace_back();
            results.claims.back().id = id;
            results.claims.back().verdict = verdict;
        }
        results.views.emplace_back();
        results.views.back().key = "v";
        results.views.back().width = width;
        results.views.back().height = 90;
        return results;
    };
    const std::string holds = ClaimRecord::kHolds, fails = ClaimRecord::kFails;
    const Results now = run({{"T01", holds}, {"T02", fails}, {"T03", holds}}, 160);
    EXPECT_EQ(changed_verdicts(now, now), "no verdict has changed\n");
    EXPECT_EQ(
        changed_verdicts(now, run({{"T01", fails}, {"T02", fails}, {"T04", fails}}, 320)),
        "T01 holds, before: does not hold\n"
        "T03 holds, before: not judged\n"
        "judged before, and not now: T04\n"
        "measured at another size: v 160x90, before: 320x90; verdicts may have changed by that alone\n");
}

TEST_F(Claims, EveryClaimOfTheListsIsAnswered) {
    REQUIRE_SHARED_INPUTS();
    const std::string text = read_file(testing::shared_dir() / "claims.md");
    const std::regex line("(^|\n)([HWGV][0-9][0-9]) \\|");
    std::set<std::string> asked, answered;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), line); it != std::sregex_iterator(); ++it)
        asked.insert((*it)[2]);
    for (const ClaimList& list : load_claims()) {
        if (list.id == "field") continue;  // its sources are no dissertations
        for (const Claim& claim : list.claims) answered.insert(claim.id);
    }
    EXPECT_EQ(asked.size(), 202u);
    EXPECT_EQ(asked, answered);
}

// The field needs twenty measured claims from more than ten sources.
TEST_F(Claims, TheFieldIsHeardInManyVoices) {
    std::set<std::string> sources;
    std::size_t measured = 0;
    for (const ClaimList& list : load_claims()) {
        if (list.id != "field") continue;
        for (const Claim& claim : list.claims) {
            sources.insert(claim.source);
            measured += claim.settings.empty() ? 0 : 1;
        }
    }
    EXPECT_GE(measured, 20u);
    EXPECT_GT(sources.size(), 10u);
}

TEST(Measured, AnExpressionOfDrawsHasAnInterval) {
    Measured a{2.0, {}}, b{4.0, {}};
    for (int i = 0; i < 1000; ++i) b.draws.push_back(4.0 + (i - 500) / 500.0);
    const Measured product = combined({a, b}, [](const auto& v) { return v[0] * v[1]; });
    EXPECT_DOUBLE_EQ(*product.value, 8.0);
    EXPECT_NEAR(product.range()->low, 6.1, 0.05);
    EXPECT_NEAR(product.range()->high, 9.9, 0.05);
    EXPECT_FALSE(combined({a, {}}, [](const auto& v) { return v[0]; }).value);
    EXPECT_FALSE(combined({a}, [](const auto& v) { return std::log(-v[0]); }).value) << "never NaN";
}

}  // namespace
}  // namespace aoscore
