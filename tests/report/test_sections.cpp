#include "report/closeness.h"
#include "report/section.h"
#include "report/synthetic_results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

struct SyntheticPage {
    Results results = testing::synthetic_results();
    Pictures pictures;
    LiveData live;

    void read_pictures() {
        const std::filesystem::path folder = testing::output_dir();
        testing::write_synthetic(results, folder);
        pictures = make_pictures(results, folder);
    }
    PageSource source() const { return {results, pictures, live}; }
};

TEST(Verdict, NamesTheClosestMethodItsLeadAndItsCost) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::verdict(page.source());
    ASSERT_EQ(model["details"].size(), 3U);
    const std::string sentence = model["details"][0];
    EXPECT_THAT(sentence, HasSubstr("atrium/wide (performance-wide)"));
    EXPECT_THAT(sentence, HasSubstr("Alchemy AO comes closest"));
    EXPECT_THAT(sentence, HasSubstr("0.0500"));
    EXPECT_THAT(sentence, HasSubstr("38 % below HBAO (Hussain)"));
    EXPECT_THAT(sentence, HasSubstr("0.28 times its milliseconds"));  // (80 + 5.5) / (300 + 5.5)
    EXPECT_THAT(sentence, HasSubstr("12.0 against 36.5 fetches"));
}

TEST(Verdict, LeadsWithTheRankingOverViewsAndItsTies) {
    SyntheticPage page;
    page.read_pictures();
    RankingRecord over_views = page.results.rankings.front();
    over_views.view_keys.push_back("atrium/close");
    page.results.rankings.push_back(over_views);
    EXPECT_EQ(section::verdict(page.source())["lead"],
              "Over 2 views Alchemy AO comes closest to the ray-traced truth: mean debiased RMSE 0.0500.");
    page.results.rankings.back().places.front().ties = {1, 2};
    EXPECT_EQ(
        section::verdict(page.source())["lead"],
        "Over 2 views Alchemy AO comes closest to the ray-traced truth (mean debiased RMSE 0.0500), but not "
        "surely: HBAO (Hussain), Crytek SSAO are tied with it.");
}

TEST(Verdict, LeavesFailedCellsOut) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::verdict(page.source());
    EXPECT_THAT(model["details"][2].get<std::string>(), HasSubstr("HBAO (Hussain) comes closest"));
    EXPECT_THAT(model["lead"].get<std::string>(),
                HasSubstr("Alchemy AO leads in 2, HBAO (Hussain) leads in 1"));
    EXPECT_TRUE(model["failed"].get<bool>());
}

TEST(Verdict, CallsADifferenceThatResamplingTurnsRoundATie) {
    SyntheticPage page;
    page.read_pictures();
    std::vector<PlaceRecord>& places = page.results.rankings.front().places;
    places[0].ties = {1};
    places[1].ties = {0};
    const json model = section::verdict(page.source());
    EXPECT_THAT(model["details"][0].get<std::string>(), HasSubstr("Alchemy AO and HBAO (Hussain) tie"));
    EXPECT_THAT(model["lead"].get<std::string>(), HasSubstr("1 is a tie"));
}

TEST(Verdict, RanksByRmseWhereTheDebiasedOneIsMissing) {
    SyntheticPage page;
    page.read_pictures();
    for (CellRecord& cell : page.results.cells) cell.ranked.erase("rmse_debiased");
    const std::string sentence = section::verdict(page.source())["details"][0];
    EXPECT_THAT(sentence, HasSubstr(": RMSE 0.0588"));  // sqrt(.05² + .031²)
}

TEST(Verdict, SaysThatNothingWasScored) {
    SyntheticPage page;
    page.results.cells.clear();
    page.results.tables.clear();
    EXPECT_EQ(section::verdict(page.source())["lead"], "Nothing was scored.");
}

TEST(Ranking, PutsTheClosestFirstAndWhatFailedApart) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::ranking(page.source());
    ASSERT_EQ(model["views"].size(), 3U);
    const json& wide = model["views"][0]["rows"];
    EXPECT_EQ(wide[0]["method"], "Alchemy AO");
    EXPECT_EQ(wide[0]["rank"]["rank"], "1");
    EXPECT_FALSE(wide[0]["rank"]["tied"].get<bool>());
    EXPECT_EQ(wide.back()["method"], "Crytek SSAO");
    ASSERT_EQ(model["failures"].size(), 1U);
    EXPECT_EQ(model["failures"][0]["view"], "atrium/close");
    EXPECT_EQ(model["failures"][0]["error"], "7 pixels are NaN or infinite");
}

TEST(Ranking, SaysWhoIsTiedAndDrawsTheInterval) {
    SyntheticPage page;
    page.read_pictures();
    RankingRecord& ranking = page.results.rankings.front();
    ranking.places[1].rank = 1;
    ranking.places[0].ties = {1};
    ranking.places[1].ties = {0};
    const json model = section::ranking(page.source());
    const json& first = model["views"][0]["rows"][0];
    EXPECT_TRUE(first["rank"]["tied"].get<bool>());
    EXPECT_EQ(first["rank"]["ties"], "tied with " + ranking.places[1].method_label);
    std::size_t bars = 0;
    for (const json& number : first["numbers"]) {
        EXPECT_EQ(number["ranks"].get<bool>(), !number["bars"].empty());
        if (number["bars"].empty()) continue;
        ++bars;
        // 0.05 and 0.048 to 0.052 on a bar that ends at 0.202.
        EXPECT_EQ(number["bars"][0]["at"], "24.75%");
        EXPECT_EQ(number["bars"][0]["low"], "23.76%");
        EXPECT_EQ(number["bars"][0]["high"], "25.74%");
    }
    EXPECT_EQ(bars, 1U);
}

TEST(Ranking, AddsATableOverAllViewsWhereThereIsOne) {
    SyntheticPage page;
    page.read_pictures();
    RankingRecord over_views = page.results.rankings.front();
    over_views.view_keys.push_back("atrium/close");
    page.results.rankings.push_back(over_views);
    const json model = section::ranking(page.source());
    ASSERT_EQ(model["overall"].size(), 1U);
    EXPECT_EQ(model["overall"][0]["views"], "atrium/wide, atrium/close");
    EXPECT_EQ(model["overall"][0]["rows"][0]["value"], "0.0500");
}

TEST(Ranking, HoldsEachCellAgainstTheBaseline) {
    SyntheticPage page;
    EXPECT_TRUE(section::ranking(page.source())["baselines"].empty());
    page.results.baseline = BaselineRecord{"0.0.9", "2025-01-01T00:00:00Z", "aoscore run", {}};
    const std::string cell = page.results.cells.front().id;
    page.results.baseline->changes = {{cell, "rmse_debiased", 0.1, 0.2, Interval{0.08, 0.12}, "worse", ""},
                                      {cell, "rmse", {}, 0.2, {}, "not comparable", "new"}};
    const json rows = section::ranking(page.source())["baselines"][0]["rows"];
    EXPECT_EQ(rows[0]["method"], "Crytek SSAO");
    EXPECT_EQ(rows[0]["change"], "0.0800 to 0.1200");
    EXPECT_TRUE(rows[0]["worse"].get<bool>());
    EXPECT_EQ(rows[1]["before"], "–");
    EXPECT_EQ(rows[1]["verdict"], "not comparable");
    EXPECT_EQ(rows[1]["reason"], "new");
}

TEST(Ranking, GivesTheNumbersOfARowOneWidth) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::ranking(page.source());
    const json& rows = model["views"][0]["rows"];
    for (std::size_t column = 0; column < model["heads"].size(); ++column) {
        std::size_t decimals = std::string::npos;
        for (const json& row : rows) {
            const std::string text = row["numbers"][column]["text"];
            if (text == "–") continue;
            const std::size_t point = text.find('.');
            const std::size_t here = point == std::string::npos ? 0 : text.size() - point - 1;
            if (decimals == std::string::npos) decimals = here;
            EXPECT_EQ(here, decimals) << model["heads"][column]["label"] << ": " << text;
        }
    }
}

TEST(Ranking, SaysWhyANumberIsMissing) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::ranking(page.source());
    ASSERT_TRUE(model["has_gaps"].get<bool>());
    EXPECT_THAT(model["gaps"][0].get<std::string>(), HasSubstr("not measured in this run"));
}

TEST(Cost, FrontIsWhatNothingBeatsInTimeAndError) {
    SyntheticPage page;
    const json charts = section::cost(page.source())["charts"];
    ASSERT_EQ(charts.size(), 2U);
    // On both presets of wide, Alchemy is both the cheapest and the closest: without its filter cheaper
    // still.
    ASSERT_EQ(charts[0]["front"].size(), 1U);
    EXPECT_EQ(charts[0]["front"][0]["method"], "Alchemy AO");
    EXPECT_EQ(charts[0]["front"][0]["preset"], "quality");
    // On close it failed: Crytek SSAO is cheaper, HBAO closer.
    ASSERT_EQ(charts[1]["front"].size(), 2U);
    EXPECT_EQ(charts[1]["front"][0]["method"], "Crytek SSAO");
    EXPECT_EQ(charts[1]["front"][1]["method"], "HBAO (Hussain)");
}

TEST(Failures, DivideMissingOcclusionByCauseAndLinkTheWorstRegions) {
    SyntheticPage page;
    ErrorAnalysis& analysis = *page.results.cells[0].analysis;
    analysis.missing.area = 0.4;
    analysis.missing.causes = {
        {"outside", 0.1, 0.2}, {"hidden", 0.2, 0.2}, {"grazing", 0, {}}, {"visible", 0.1, 0.2}};
    analysis.regions = {{"missing", 3, 4, 10, 20, 5, 6, 0.9, 120, 0.45, "hidden"}};
    const json view = section::failures(page.source())["views"][0];
    const json& row = view["rows"][0];
    ASSERT_EQ(row["parts"].size(), 4U);
    EXPECT_EQ(row["shares"][1]["text"], "20.00");
    EXPECT_EQ(row["missing"], "40.00");
    const json& region = view["methods"][0]["regions"][0];
    EXPECT_EQ(region["box"], "3,4,10,20");
    EXPECT_EQ(region["mean"], "+0.45");
    EXPECT_EQ(region["cause"], "hidden");
}

TEST(Distributions, SayWhatCalibrationAloneWouldMend) {
    SyntheticPage page;
    page.results.cells[0].analysis->fit = {1.5, 0.5, 0.11, 0.1, 0};
    const json view = section::distributions(page.source())["views"][0];
    const json& numbers = view["fits"][0]["numbers"];
    EXPECT_EQ(numbers[0]["text"], "1.50");
    EXPECT_EQ(numbers[2]["text"], "0.2000");
    EXPECT_EQ(numbers[3]["text"], "0.1000");
    EXPECT_EQ(numbers[4]["text"], "50");
    const json curves = json::parse(view["histogram"].get<std::string>());
    EXPECT_EQ(curves["series"].size(), 6U);
    EXPECT_NEAR(curves["low"].get<double>(), -1, 1e-9);
    EXPECT_NEAR(curves["step"].get<double>(), 0.01, 1e-9);
}

const json& pair_of(const json& table, std::size_t row, std::size_t column) {
    return table["rows"][row]["pairs"][column];
}

TEST(PublishedTables, PutRatiosToTheFirstRowBesideEachOther) {
    SyntheticPage page;
    page.read_pictures();
    const json table = section::published(page.source())["tables"][0];
    ASSERT_EQ(table["rows"].size(), 3U);
    EXPECT_EQ(pair_of(table, 0, 1)["published"]["text"], "1.00");
    EXPECT_EQ(pair_of(table, 1, 1)["published"]["text"], "2.36");   // 3.16 / 1.34
    EXPECT_EQ(pair_of(table, 2, 1)["published"]["text"], "0.82");   // 1.10 / 1.34
    EXPECT_EQ(pair_of(table, 1, 1)["ours"]["text"], "3.00");        // 300 / 100
    EXPECT_EQ(pair_of(table, 2, 1)["ours"]["text"], "0.80");        // 80 / 100
    EXPECT_EQ(pair_of(table, 1, 5)["published"]["text"], "0.088");  // 3.16 / 36
    EXPECT_EQ(pair_of(table, 1, 5)["ours"]["text"], "8.219");       // 300 / 36.5
}

TEST(PublishedTables, ShowBothNumbersWhereTheSourceContradictsItself) {
    SyntheticPage page;
    page.read_pictures();
    const json table = section::published(page.source())["tables"][2];
    const json& alchemy = pair_of(table, 2, 0)["published"];
    EXPECT_EQ(alchemy["text"], "5.80");
    EXPECT_EQ(alchemy["other"], "5.88 (text)");
    EXPECT_EQ(pair_of(table, 2, 1)["published"]["other"], "0.42 (text)");  // 5.88 / 13.84
    EXPECT_THAT(table["rows"][2]["published_parameters"].dump(), HasSubstr("0.3 (0.001 in the listing)"));
    EXPECT_THAT(table["notes"].dump(), HasSubstr("5.88 ms five times"));
    EXPECT_EQ(pair_of(table, 0, 2)["published"]["text"], "–") << "table 5 applies no blur";
}

TEST(PublishedTables, RankAtOneRadiusAndBesideItAtEachMethodsOwn) {
    SyntheticPage page;
    page.read_pictures();
    const json table = section::published(page.source())["tables"][0];
    EXPECT_EQ(table["rows"][2]["errors"][0]["text"], "0.0500");
    EXPECT_EQ(table["rows"][2]["errors"][3]["text"], "0.0250");
    EXPECT_EQ(table["rows"][2]["own_truth"], "quadratic, R 0.549 m");
}

TEST(PublishedTables, HaveNoRatioToARowThatFailed) {
    SyntheticPage page;
    page.results.cells[0].error = "lost";
    page.results.cells[0].ao = {};
    page.read_pictures();
    const json table = section::published(page.source())["tables"][0];
    EXPECT_TRUE(table["rows"][0]["failed"].get<bool>());
    EXPECT_EQ(pair_of(table, 1, 1)["ours"]["text"], "–");
    EXPECT_EQ(pair_of(table, 1, 1)["published"]["text"], "2.36");
}

TEST(Measurement, NamesTruthMachineCommandAndWarnings) {
    SyntheticPage page;
    const json model = section::measurement(page.source());
    EXPECT_EQ(model["command"], "aoscore run");
    EXPECT_THAT(model["warnings"].dump(), HasSubstr("a synthetic warning"));
    const std::string views = model["views"].dump();
    EXPECT_THAT(views, HasSubstr("64 samples a pixel"));
    EXPECT_THAT(views, HasSubstr("0.0310"));
    EXPECT_THAT(views, HasSubstr("alchemy, u 0.128 m, R infinite"));
    EXPECT_THAT(views, HasSubstr("2 disagree (0.010 %"));  // of 20336 - 300
    EXPECT_THAT(views, HasSubstr("triangles lay out of reach and were not built for tracing"));
    EXPECT_THAT(model["machine"].dump(), HasSubstr("llvmpipe (synthetic)"));
}

TEST(Measurement, StatesTheRadiusItsRuleAndEachMethodsLengths) {
    SyntheticPage page;
    const json view = section::measurement(page.source())["views"][0];
    EXPECT_THAT(view["facts"].dump(), HasSubstr("R 0.5 m (named by the view), 12.5 pixels in the median"));
    ASSERT_TRUE(view["has_lengths"].get<bool>());
    const std::string lengths = view["lengths"].dump();
    EXPECT_THAT(lengths, HasSubstr("\"radius 0.549 m\""));
    EXPECT_THAT(lengths, HasSubstr("radius 0.549 m (fixed by the preset)"));
}

}  // namespace
}  // namespace aoscore
