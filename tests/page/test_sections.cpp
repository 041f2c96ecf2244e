#include "metrics/analysis/best_fit.h"
#include "page/document/stage_link.h"
#include "page/pictures/first_look.h"
#include "page/ranking_order.h"
#include "page/section.h"
#include "page/synthetic_results.h"
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

RankingRecord over_both_views(const Results& results) {
    RankingRecord over_views = results.rankings.front();
    over_views.view_keys.push_back("atrium/close");
    for (PlaceRecord& place : over_views.places) place.cell_ids.push_back(place.cell_ids.front());
    return over_views;
}

TEST(Verdict, NamesTheClosestMethodAndItsLead) {
    SyntheticPage page;
    const json model = section::verdict(page.source());
    ASSERT_EQ(model["details"].size(), 3U) << "one a view, whatever the presets, and one of the next step";
    EXPECT_EQ(model["details"][0],
              "Alchemy AO, quality is closest of 6 methods to the ray-traced truth on atrium/wide: its "
              "debiased RMSE is 0.0400, 20 % below that of Alchemy AO, performance-wide.");
    EXPECT_EQ(model["details"][1],
              "HBAO (Hussain) is closest of 2 methods to the ray-traced truth on atrium/close: its debiased "
              "RMSE is 0.0800, 60 % below that of Crytek SSAO.");
}

TEST(Verdict, LeadsWithTheRankingOverViewsAndSaysWhichTheyAre) {
    SyntheticPage page;
    page.results.rankings.erase(page.results.rankings.begin() + 1);
    page.results.rankings.push_back(over_both_views(page.results));
    EXPECT_EQ(section::verdict(page.source())["lead"],
              "Alchemy AO, quality is closest of 6 methods to the ray-traced truth over atrium/wide and "
              "atrium/close (R 0.5 m): its debiased RMSE is 0.0400, 20 % below that of Alchemy AO, "
              "performance-wide.");
    std::vector<PlaceRecord>& places = page.results.rankings.back().places;
    for (std::size_t i = 0; i < 3; ++i) places[i].rank = RankRange{1, 3};
    EXPECT_EQ(section::verdict(page.source())["lead"],
              "Alchemy AO, quality (0.0400), Alchemy AO, performance-wide (0.0500) and HBAO (Hussain), "
              "quality (0.0640) tie as the closest of 6 methods to the ray-traced truth over atrium/wide and "
              "atrium/close (R 0.5 m): their debiased RMSEs do not differ significantly.");
}

TEST(Verdict, DoesNotLeadWithARankingOverViewsThatLacksWhatLeadsOnOne) {
    SyntheticPage page;
    page.results.rankings.push_back(over_both_views(page.results));
    const std::string lead = section::verdict(page.source())["lead"];
    EXPECT_THAT(lead, HasSubstr("Of 2 views, the closest method")) << "HBAO leads on close and is not in it";
}

TEST(Verdict, CountsTheViewsOnWhichAMethodSurelyLeads) {
    SyntheticPage page;
    for (const char* key : {"atrium/a", "atrium/b"}) {
        page.results.rankings.push_back(page.results.rankings.front());
        page.results.rankings.back().view_keys = {key};
    }
    page.results.rankings.back().places[0].rank = page.results.rankings.back().places[1].rank =
        RankRange{1, 2};
    const json model = section::verdict(page.source());
    EXPECT_EQ(model["lead"],
              "Of 4 views, the closest method to the ray-traced truth is Alchemy AO, quality on 2 and HBAO "
              "(Hussain) on 1; several methods tie on 1.");
    EXPECT_TRUE(model["failed"].get<bool>());
}

TEST(Verdict, LetsNeitherABoundNorWhatIsAloneWin) {
    SyntheticPage page;
    page.results.rankings.resize(1);
    std::vector<PlaceRecord>& places = page.results.rankings.front().places;
    places.resize(3);
    places[0].rank.reset();
    places[1].rank = places[2].rank = RankRange{1, 2};
    const json model = section::verdict(page.source());
    EXPECT_EQ(model["lead"],
              "Alchemy AO, performance-wide (0.0500) and HBAO (Hussain) (0.0640) tie as the closest of 2 "
              "methods to the ray-traced truth on atrium/wide: their debiased RMSEs do not differ "
              "significantly.");
    EXPECT_EQ(model["details"][0],
              "Alchemy AO, quality (0.0400) is not for use and has no rank: it shows how far one depth layer "
              "goes on atrium/wide.");
    places.resize(2);
    places[1].rank = RankRange{1, 1};
    EXPECT_EQ(section::verdict(page.source())["lead"],
              "Alchemy AO, performance-wide is the only method scored on atrium/wide: its debiased RMSE is "
              "0.0500.");
    places.resize(1);
    EXPECT_EQ(section::verdict(page.source())["lead"], "On atrium/wide no method for use was scored.");
    page.results.rankings.clear();
    EXPECT_EQ(section::verdict(page.source())["lead"], "No method could be scored.");
}

TEST(Ranking, PutsTheClosestFirstAndWhatFailedApart) {
    SyntheticPage page;
    page.read_pictures();
    const json model = section::ranking(page.source());
    ASSERT_EQ(model["views"].size(), 2U);
    const json& wide = model["views"][0]["rows"];
    ASSERT_EQ(wide.size(), 6U);
    EXPECT_EQ(wide[0]["method"], "Alchemy AO");
    EXPECT_EQ(wide[0]["preset"], "quality");
    EXPECT_EQ(wide[0]["rank"]["rank"], "1");
    EXPECT_EQ(wide[0]["rank"]["ties"], "");
    EXPECT_EQ(wide.back()["method"], "Crytek SSAO");
    ASSERT_EQ(model["failures"].size(), 1U);
    EXPECT_EQ(model["failures"][0]["view"], "atrium/close");
    EXPECT_EQ(model["failures"][0]["error"], "7 pixels are NaN or infinite");
}

TEST(Ranking, SaysWhatCannotBeToldApartAndDrawsTheInterval) {
    SyntheticPage page;
    page.read_pictures();
    std::vector<PlaceRecord>& places = page.results.rankings.front().places;
    places[0].rank = RankRange{1, 2};
    places[1].rank = RankRange{1, 3};
    places[0].ties = {1};
    places[1].ties = {0, 2};
    places[5].rank.reset();
    const json model = section::ranking(page.source());
    const json& rows = model["views"][0]["rows"];
    const json& first = rows[0];
    EXPECT_EQ(first["rank"]["rank"], "1–2");
    EXPECT_EQ(rows[1]["rank"]["rank"], "1–3");
    EXPECT_LT(std::stod(first["rank"]["sort"].get<std::string>()),
              std::stod(rows[1]["rank"]["sort"].get<std::string>()));
    EXPECT_EQ(first["rank"]["ties"], "not surely apart from Alchemy AO, performance-wide");
    EXPECT_EQ(rows[5]["rank"]["rank"], "bound");
    std::size_t bars = 0;
    for (const json& number : first["numbers"]) {
        EXPECT_EQ(number["ranks"].get<bool>(), !number["bars"].empty());
        if (number["bars"].empty()) continue;
        ++bars;
        // 0.04 and 0.038 to 0.042 on a bar that ends at 0.202.
        EXPECT_EQ(number["bars"][0]["at"], "19.80%");
        EXPECT_EQ(number["bars"][0]["low"], "18.81%");
        EXPECT_EQ(number["bars"][0]["high"], "20.79%");
    }
    EXPECT_EQ(bars, 1U);
}

TEST(Ranking, AddsATableOverViewsThatSaysWhichAndWhatItLacks) {
    SyntheticPage page;
    page.read_pictures();
    page.results.rankings.push_back(over_both_views(page.results));
    const json model = section::ranking(page.source());
    ASSERT_EQ(model["overall"].size(), 1U);
    const json& table = model["overall"][0];
    EXPECT_EQ(table["views"], "atrium/wide, atrium/close");
    EXPECT_EQ(table["radius"], "0.5");
    EXPECT_EQ(table["rows"][0]["value"], "0.0400");
    EXPECT_EQ(table["rows"][0]["behind"], "–");
    EXPECT_EQ(table["rows"][1]["behind"], "0.0090 to 0.0110");
    EXPECT_THAT(table["left_out"].get<std::string>(),
                HasSubstr("HBAO (Hussain), performance-close (1 of 2 views)"));
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
    // On wide, Alchemy is the cheapest and has the least error with both presets, and is cheaper still
    // without its filter.
    ASSERT_EQ(charts[0]["front"].size(), 1U);
    EXPECT_EQ(charts[0]["front"][0]["method"], "Alchemy AO");
    EXPECT_EQ(charts[0]["front"][0]["preset"], "quality");
    // On close it failed: Crytek SSAO is cheaper, and HBAO has less error.
    ASSERT_EQ(charts[1]["front"].size(), 2U);
    EXPECT_EQ(charts[1]["front"][0]["method"], "Crytek SSAO");
    EXPECT_EQ(charts[1]["front"][1]["method"], "HBAO (Hussain)");
}

TEST(Cost, SaysInShortWhatNoOtherMethodBeats) {
    SyntheticPage page;
    EXPECT_EQ(section::cost(page.source())["in_short"],
              "On atrium/wide, Alchemy AO, quality is the fastest and closest of 6 methods.");
}

TEST(Cost, NamesNoMethodTheFirstOfOne) {
    SyntheticPage page;
    const CellRecord* timed = nullptr;
    for (CellRecord& cell : page.results.cells) {
        const bool first = timed == nullptr && cell.view_key == "atrium/wide" && cell.role == kMethodRole;
        if (first) timed = &cell;
        if (!first) cell.ao = {};
    }
    EXPECT_EQ(section::cost(page.source())["in_short"],
              "On atrium/wide, " + shown_name(*timed) + ", " + timed->preset +
                  " is the only method with both a time and an error.");
}

TEST(Cost, PutsNoBoundOnTheFront) {
    SyntheticPage page;
    for (CellRecord& cell : page.results.cells) {
        if (cell.id == "atrium/wide/alchemy/quality") cell.role = kBoundRole;
    }
    const json chart = section::cost(page.source())["charts"][0];
    ASSERT_EQ(chart["front"].size(), 1U) << "the same method with its filter is next";
    EXPECT_EQ(chart["front"][0]["preset"], "performance-wide");
    std::size_t bounds = 0;
    for (const json& point : json::parse(chart["data"].get<std::string>()))
        bounds += point["bound"].get<bool>();
    EXPECT_EQ(bounds, 1U) << "it is shown all the same";
}

TEST(Failures, DivideMissingOcclusionByCauseAndLinkTheWorstRegions) {
    SyntheticPage page;
    ErrorAnalysis& analysis = *page.results.cells[0].analysis;
    analysis.missing.area = 0.4;
    analysis.missing.causes = {
        {"outside", 0.1, 0.2}, {"hidden", 0.2, 0.2}, {"grazing", 0, {}}, {"visible", 0.1, 0.2}};
    analysis.regions = {{"missing", 3, 4, 10, 20, 5, 6, 0.9, 120, 0.45, "hidden"}};
    EXPECT_FALSE(section::failures(page.source())["views"][0]["has_regions"]) << "without pictures";
    page.pictures.cells[page.results.cells[0].id] = {};
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

TEST(Distributions, SayWhereAFitEndedAtABoundOfItsRange) {
    // An image of constant visibility 0.99 under a black truth: the darkest curve fits best.
    const ImageF truth(8, 8, 0.0F), test(8, 8, 0.99F);
    const Mask valid(8, 8, 1);
    SyntheticPage page;
    page.results.cells[0].analysis->fit = *best_fit({truth, test, valid, nullptr});
    const json numbers = section::distributions(page.source())["views"][0]["fits"][0]["numbers"];
    EXPECT_EQ(numbers[0]["text"], "4.00, the end of the range");
    EXPECT_EQ(numbers[1]["text"], "8.00, the end of the range");
    page.results.cells[0].analysis->fit = {3.9, 7.9, 0.11, 0.1, 0, {}};
    const json inside = section::distributions(page.source())["views"][0]["fits"][0]["numbers"];
    EXPECT_EQ(inside[0]["text"], "3.90");
    EXPECT_EQ(inside[1]["text"], "7.90");
}

TEST(Distributions, SayWhatCalibrationAloneWouldMend) {
    SyntheticPage page;
    page.results.cells[0].analysis->fit = {1.5, 0.5, 0.11, 0.1, 0, {}};
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
    EXPECT_THAT(views, HasSubstr("2 disagree: 0.010 %"));  // of 20336 - 300
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

TEST(FoldedSections, SayTheirResultInASentence) {
    SyntheticPage page;
    page.read_pictures();
    for (const Section& section : sections()) {
        if (!section.folded) continue;
        if (section.applies != nullptr && !section.applies(page.results)) continue;
        const std::string line = section.build(page.source()).value("in_short", "");
        EXPECT_TRUE(line.ends_with(".")) << section.id << ": " << line;
    }
}

TEST(FirstLook, ShowsTheFirstOfTheRankingItsErrorAndItsWorstRegion) {
    SyntheticPage page;
    page.results = in_ranking_order(page.results);
    for (CellRecord& cell : page.results.cells) {
        if (cell.analysis)
            cell.analysis->regions = {{"missing", 3, 4, 10, 20, 5, 6, 0.9, 120, 0.45, "hidden"},
                                      {"false", 30, 4, 10, 20, 5, 6, -0.9, 20, -0.5, ""}};
    }
    page.read_pictures();
    const json looks = section::verdict(page.source())["looks"];
    ASSERT_EQ(looks.size(), page.results.views.size());
    EXPECT_EQ(looks[0]["winner"], "Alchemy AO");
    const json& pictures = looks[0]["pictures"];
    ASSERT_EQ(pictures.size(), 4U);
    EXPECT_EQ(pictures[1]["title"], "Alchemy AO, quality");
    EXPECT_EQ(pictures[2]["link"],
              "#view=atrium/wide&cell=atrium/wide/alchemy/quality&picture=error&mode=beside");
    EXPECT_EQ(
        pictures[3]["text"],
        "It is too bright by 0.45 over 120 pixels. There the occluder lies behind what the camera sees.");
    EXPECT_THAT(pictures[3]["link"].get<std::string>(), HasSubstr("&at=3,4,10,20"));
    EXPECT_EQ(pictures[3]["images"].size(), 2U) << "truth beside output";
    for (const json& picture : pictures) {
        for (const json& image : picture["images"])
            EXPECT_THAT(image["uri"].get<std::string>(), ::testing::StartsWith("data:image/png;base64,"));
    }
}

TEST(FirstLook, SaysWhereEveryMethodFailed) {
    SyntheticPage page;
    for (CellRecord& cell : page.results.cells) cell.error = "lost";
    page.results.rankings.clear();
    page.read_pictures();
    const json look = section::verdict(page.source())["looks"][0];
    EXPECT_EQ(look["winner"], "every method failed");
    EXPECT_EQ(look["pictures"].size(), 1U) << "the truth alone";
}

TEST(RankingOrder, ListsTheCellsOfEveryViewBestFirstAndFailedOnesLast) {
    const Results results = in_ranking_order(testing::synthetic_results());
    std::vector<std::string> wanted;
    for (const ViewRecord& view : results.views) {
        for (const RankingRecord& ranking : results.rankings) {
            if (ranking.view_keys != std::vector{view.key}) continue;
            for (const PlaceRecord& place : ranking.places) wanted.push_back(place.cell_ids.front());
        }
        for (const CellRecord& cell : results.cells) {
            if (cell.view_key == view.key && !cell.error.empty()) wanted.push_back(cell.id);
        }
    }
    std::vector<std::string> listed_ids;
    for (const CellRecord& cell : results.cells) listed_ids.push_back(cell.id);
    EXPECT_EQ(listed_ids, wanted);
}

TEST(StageLink, EncodesWhatAnAddressCannotHold) {
    EXPECT_EQ(stage_link({{"view", "a/b"}, {"cell", "x&y=z +é"}}), "#view=a/b&cell=x%26y%3Dz%20%2B%C3%A9");
}

}  // namespace
}  // namespace aoscore
