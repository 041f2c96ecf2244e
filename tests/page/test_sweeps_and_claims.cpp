#include "page/document/number_text.h"
#include "page/section.h"
#include "page/synthetic_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class SweepsAndClaims : public ::testing::Test {
  protected:
    Results results = testing::synthetic_results();
    Pictures pictures;
    LiveData live;
    PageSource source() const { return {results, pictures, live}; }
};

TEST_F(SweepsAndClaims, TheFrontIsMadeWithinEachView) {
    const auto views = section::sweeps(source()).at("sweeps").at(0).at("views");
    ASSERT_EQ(views.size(), 2u);
    bool any = false;
    for (const auto& row : views.at(0).at("rows")) {
        // Of the synthetic methods Alchemy is the cheapest and has the least error.
        const bool on_front = row.at("front").get<bool>();
        any |= on_front;
        EXPECT_TRUE(!on_front || row.at("method") == "Alchemy AO") << row;
    }
    EXPECT_TRUE(any);
    for (const auto& view : views)
        EXPECT_THAT(view.at("answer").get<std::string>(), HasSubstr("Within 200 ms"));
}

TEST_F(SweepsAndClaims, ATimeThatCannotBeToldFromTheFrontsIsSaidToBeOne) {
    const auto answer = [&] {
        return section::sweeps(source()).at("sweeps").at(0).at("views").at(0).at("answer").get<std::string>();
    };
    EXPECT_THAT(answer(), Not(HasSubstr("cannot be told apart")));
    // The least error goes to the second, which is slower in the median and not for sure.
    std::vector<CellRecord*> cells;
    for (CellRecord& cell : results.cells) {
        if (cell.view_key == results.views[0].key && cell.role == kMethodRole && cell.error.empty())
            cells.push_back(&cell);
    }
    ASSERT_GE(cells.size(), 2U);
    for (CellRecord* cell : cells) {
        cell->ranked.at("rmse_debiased").value = 0.5;
        cell->filter_pass.runs_ms.clear();
        cell->ao.runs_ms.assign(12, 1000.0);
    }
    cells[0]->ranked.at("rmse_debiased").value = 0.1;
    cells[0]->ao.runs_ms = {9, 9.5, 10, 10, 10, 10, 10, 10, 10.5, 11, 12, 13};
    cells[1]->ranked.at("rmse_debiased").value = 0.2;
    const std::string untold = "cannot be told apart from these: " + cells[1]->method_label;
    cells[1]->ao.runs_ms = {9, 9.5, 10, 10, 10.1, 10.1, 10.1, 10.2, 10.5, 11, 12, 13};
    EXPECT_THAT(answer(), HasSubstr(untold));
    cells[1]->ao.runs_ms.assign(12, 100.0);
    EXPECT_THAT(answer(), Not(HasSubstr("cannot be told apart")));
}

TEST_F(SweepsAndClaims, ALineOfTheChartJoinsSettingsThatDifferByNumbersAlone) {
    SweepRecord& sweep = results.sweeps[0];
    const auto labels = [&] {
        const auto view = section::sweeps(source()).at("sweeps").at(0).at("views").at(0);
        std::set<std::string> all;
        const nlohmann::json data = nlohmann::json::parse(view.at("data").get<std::string>());
        for (const auto& curve : data.at("curves")) all.insert(curve.at("label"));
        return all;
    };
    const std::set<std::string> methods = labels();
    EXPECT_TRUE(methods.contains("Alchemy AO"));
    for (SweepPointRecord& point : sweep.points) point.at["kernel"] = "box";
    EXPECT_TRUE(labels().contains("Alchemy AO, box"));
    EXPECT_EQ(labels().size(), methods.size());
    for (std::size_t i = 0; i < sweep.points.size(); ++i)
        sweep.points[i].at["kernel"] = "word" + std::to_string(i);
    EXPECT_GT(labels().size(), methods.size());
    const std::vector<SweepPointRecord> some = sweep.points;
    while (sweep.points.size() < 40) {
        sweep.points.push_back(some[sweep.points.size() % some.size()]);
        sweep.points.back().at["kernel"] = "further" + std::to_string(sweep.points.size());
    }
    EXPECT_EQ(labels(), methods) << "more curves than a reader can tell apart";
}

TEST_F(SweepsAndClaims, TheBudgetNamesWhatFitsIntoIt) {
    results.sweeps[0].budget_ms = 0.001;
    const auto view = section::sweeps(source()).at("sweeps").at(0).at("views").at(0);
    EXPECT_THAT(view.at("answer").get<std::string>(), HasSubstr("Nothing fits"));
    for (const auto& row : view.at("rows")) EXPECT_FALSE(row.at("within").get<bool>());
}

TEST_F(SweepsAndClaims, FramesAreGivenByTheirPassesAndByTheSecond) {
    const auto view = section::sweeps(source()).at("sweeps").at(0).at("views").at(0);
    ASSERT_TRUE(view.at("has_frames").get<bool>());
    const auto& frame = view.at("frames").at(0);
    EXPECT_EQ(frame.at("both"), "20.0") << "geometry 11 ms and lighting 9 ms";
    EXPECT_EQ(frame.at("lighting"), "9.0 ± 0.5");
    EXPECT_EQ(frame.at("ao"), "100.0");
    EXPECT_EQ(frame.at("frame"), "125.5") << "with 5.5 ms of filter";
    EXPECT_EQ(frame.at("both_share"), "15.9");
    EXPECT_EQ(frame.at("without_ao"), "50.00");
    EXPECT_EQ(frame.at("with_ao"), "8.33");
    EXPECT_EQ(frame.at("with_filter"), "7.97");
    EXPECT_THAT(view.at("light").get<std::string>(), HasSubstr("Four lights (lights 4)"));
    for (CellRecord& cell : results.cells) cell.frame.reset();
    EXPECT_FALSE(section::sweeps(source()).at("sweeps").at(0).at("views").at(0).at("has_frames").get<bool>());
}

TEST_F(SweepsAndClaims, PrintedTimesStandBesideThoseOfTheSameSettingAsPartsOfTheFirst) {
    SweepRecord& sweep = results.sweeps[0];
    std::erase_if(sweep.points,
                  [](const SweepPointRecord& p) { return !p.cell_id.starts_with("atrium/wide/"); });
    for (CellRecord& cell : results.cells) {
        cell.ao.processor_runs_ms = {cell.id == sweep.points[1].cell_id ? 50.0 : 30.0};
        cell.layers_processor.runs_ms = {10.0};
        cell.layers_processor.median_ms = 10;
    }
    const auto at = [&](std::size_t i) { return nlohmann::json(sweep.points[i].at); };
    sweep.definition = {{"source", {{"author", "A"}, {"title", "T"}, {"year", 2020}}},
                        {"hardware", "a card"}};
    sweep.definition["views"] = {
        {{"printed",
          {{{"at", at(0)}, {"ao_ms", 1.2}}, {{"at", at(1)}, {"ao_ms", 3.0}, {"layers_ms", 0.5}}}}}};
    const auto view = section::sweeps(source()).at("sweeps").at(0).at("views").at(0);
    ASSERT_TRUE(view.at("has_printed").get<bool>());
    const auto& rows = view.at("printed").at("rows");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].at("ao"), "1.00");
    EXPECT_EQ(rows[1].at("ao"), "2.50");
    EXPECT_EQ(rows[1].at("our_ao"), "2.00") << "40 over 20 ms without the layers";
    EXPECT_EQ(rows[0].at("layers_ms"), kNoNumber);
    EXPECT_EQ(rows[1].at("layers"), "1.00") << "the first that has one is itself";
    EXPECT_EQ(rows[1].at("found"), kNoNumber) << "not drawn again";
}

TEST_F(SweepsAndClaims, SettingsOverSeveralLayersStandBesideWhatOneLayerCannotKnow) {
    const auto first_view = [&] { return section::sweeps(source()).at("sweeps").at(0).at("views").at(0); };
    EXPECT_FALSE(first_view().at("has_findings").get<bool>()) << "no method reads layers";
    EXPECT_EQ(first_view().at("finder"), "");
    const std::string second = results.sweeps[0].points[1].cell_id;
    for (CellRecord& cell : results.cells) {
        cell.layer_bytes = 1e6;
        cell.analysis->found_beyond_layer = cell.id == second ? 0.625 : 0.25;
        Repeats& repeats = cell.repeats.emplace();
        repeats.counts = {100};
        repeats.variance = {1};  // 0.01 a pixel
        repeats.of_layers.emplace().hidden = {10};
        repeats.of_layers->found_fitted = {8};
        repeats.of_truth.emplace().strength = 2;
        repeats.of_truth->hidden = {10};
        repeats.of_truth->found_fitted = {5};
    }
    const auto view = first_view();
    ASSERT_TRUE(view.at("has_findings").get<bool>());
    EXPECT_EQ(view.at("rows").at(0).at("beyond_layer"), "25.0");
    EXPECT_EQ(view.at("rows").at(1).at("beyond_layer"), "62.5");
    EXPECT_EQ(view.at("rows").at(0).at("found_of_layers"), "80.0");
    EXPECT_EQ(view.at("rows").at(0).at("noise"), "0.2000") << "0.1 at twice the strength";
    EXPECT_THAT(view.at("finder").get<std::string>(), HasSubstr("shows the most: 62.5 %"));
}

TEST_F(SweepsAndClaims, ASweepSaysOfEachConclusionOfItsSourceWhetherItHoldsAndByWhichNumbers) {
    SweepRecord& sweep = results.sweeps[0];
    std::vector<std::string> ids;
    for (const ClaimRecord& claim : results.claims) ids.push_back(claim.id);
    sweep.definition = {{"source", {{"author", "A"}, {"title", "T"}, {"year", 2020}}},
                        {"hardware", "a card"},
                        {"claims", ids},
                        {"views", {nlohmann::json::object()}}};
    const auto model = section::sweeps(source()).at("sweeps").at(0).at("source");
    EXPECT_EQ(model.at("conclusion"), "of 3 claims, 1 holds, 1 does not hold and 1 cannot be told here");
    ASSERT_EQ(model.at("claims").size(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto& claim = model.at("claims").at(i);
        EXPECT_EQ(claim.at("id"), ids[i]);
        EXPECT_EQ(claim.at("verdict"), results.claims[i].verdict);
        EXPECT_NE(claim.at("numbers"), "");
    }
    EXPECT_THAT(model.at("claims").at(0).at("numbers").get<std::string>(),
                HasSubstr(": 1.25 ms (1.00 to 1.50), claimed above 0"));
}

TEST_F(SweepsAndClaims, VerdictsAreCountedBySourceAndOverall) {
    results.claims.back().source = "Another, Title, 2021";
    const auto model = section::claims(source());
    ASSERT_EQ(model.at("sources").size(), 2u);
    const auto count = [](const nlohmann::json& counts, const std::string& verdict) {
        for (const auto& one : counts) {
            if (one.at("verdict") == verdict) return one.at("count").get<std::string>();
        }
        return std::string("none");
    };
    EXPECT_EQ(count(model.at("sources")[0].at("counts"), ClaimRecord::kHolds), "1");
    EXPECT_EQ(count(model.at("sources")[0].at("counts"), ClaimRecord::kCannotTell), "0");
    EXPECT_EQ(count(model.at("overall"), ClaimRecord::kCannotTell), "1");
    EXPECT_EQ(count(model.at("overall"), "all"), "3");
    const auto claim = model.at("sources")[0].at("claims")[0];
    EXPECT_EQ(claim.at("findings")[0].at("measured"), "1.25 ms (1.00 to 1.50)");
    EXPECT_EQ(claim.at("findings")[0].at("claimed"), "above 0");
    EXPECT_EQ(claim.at("errors").size(), 1u) << "what the truth adds";
}

TEST_F(SweepsAndClaims, EveryClaimSaysHowManyOfItsPartsHold) {
    ClaimRecord& claim = results.claims.front();
    claim.findings.resize(1);
    claim.findings.push_back(claim.findings.front());
    claim.findings[0].outcome = ClaimRecord::kHolds;
    claim.findings[1].outcome = ClaimRecord::kFails;
    results.claims.back().findings.clear();
    const auto model = section::claims(source());
    EXPECT_TRUE(model.at("several").get<bool>());
    const auto parts = [&](const ClaimRecord& wanted) {
        for (const auto& one : model.at("sources")) {
            for (const auto& each : one.at("claims")) {
                if (each.at("id") == wanted.id) return each.at("parts").get<std::string>();
            }
        }
        return std::string("none");
    };
    EXPECT_EQ(parts(claim), "1 of 2");
    EXPECT_EQ(parts(results.claims.back()), kNoNumber);
}

TEST_F(SweepsAndClaims, SectionsWithoutAnythingToSayAreLeftOut) {
    results.sweeps.clear();
    results.claims.clear();
    results.advice.clear();
    const std::set<std::string_view> about_them{"sweeps", "claims", "signals", "light", "advice"};
    for (const Section& section : sections()) {
        EXPECT_EQ(section.applies == nullptr || section.applies(results), !about_them.contains(section.id))
            << section.id;
    }
}

}  // namespace
}  // namespace aoscore
