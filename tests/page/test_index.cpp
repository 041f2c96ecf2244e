#include "core/files.h"
#include "page/index/index_page.h"
#include "page/index/scene_ranking.h"
#include "page/index_results.h"
#include "page/page.h"
#include "page/synthetic_results.h"
#include "results/light_modes.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Index, RanksWhatWasScoredOnEveryView) {
    const IndexContents contents = testing::synthetic_index(12, 3, 5).contents();
    EXPECT_EQ(contents.cells.size(), 12U * 3 * 5);
    const SceneRanking ranking = rank_over_scenes(contents, 1);
    EXPECT_EQ(ranking.scenes, 12U);
    EXPECT_EQ(ranking.views, 36U);
    EXPECT_EQ(ranking.left_out, 1U) << "the last failed on some views";
    ASSERT_EQ(ranking.places.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const ScenePlace& place = ranking.places[i];
        EXPECT_EQ(place.contestant, i) << "every view has this order";
        EXPECT_EQ(place.rank, (RankRange{static_cast<int>(i) + 1, static_cast<int>(i) + 1}));
        EXPECT_LE(place.interval->low, place.error);
        EXPECT_GE(place.interval->high, place.error);
        const IndexedCell& worst = contents.cells[place.worst_cell];
        EXPECT_EQ(worst.contestant, i);
        for (const IndexedCell& cell : contents.cells) {
            if (cell.contestant != i) continue;
            EXPECT_LE(*cell.error, *worst.error);
        }
        EXPECT_DOUBLE_EQ(*place.ms, 1.0 + static_cast<double>(i));
    }
    EXPECT_THAT(
        scene_sentence(ranking, contents),
        HasSubstr("Method 0, default, box-4x4 is closest of 4 methods to the ray-traced truth over 12 scenes "
                  "with 36 views"));
}

TEST(Index, RanksOverTheViewsThatMostContestantsShare) {
    IndexBuilder index = testing::synthetic_index(6, 2, 4);
    Results alone = testing::without_pictures(testing::synthetic_results());
    alone.views.resize(1);
    std::erase_if(alone.cells, [&](const CellRecord& cell) { return cell.view_key != alone.views[0].key; });
    index.add(alone, "nowhere");
    const SceneRanking ranking = rank_over_scenes(index.contents(), 1);
    EXPECT_EQ(ranking.places.size(), 3U) << "three methods on 12 views are more cells than six on one";
    EXPECT_EQ(ranking.views, 12U);
    EXPECT_EQ(ranking.scenes, 6U);
    EXPECT_EQ(ranking.left_out, index.contents().contestants.size() - 3);
}

TEST(Index, SaysThatOneSceneCannotSpeakForOthers) {
    const IndexContents contents = testing::synthetic_index(1, 3, 3).contents();
    const SceneRanking ranking = rank_over_scenes(contents, 1);
    for (const ScenePlace& place : ranking.places) EXPECT_FALSE(place.rank);
    EXPECT_THAT(scene_sentence(ranking, contents), HasSubstr("cannot be told"));
}

TEST(Index, KeepsTheLatestOfTheSameContestantOnTheSameView) {
    IndexBuilder index("index");
    Results results = testing::without_pictures(testing::synthetic_results());
    index.add(results, "nowhere");
    const std::size_t cells = index.contents().cells.size();
    results.created_utc = "2027-01-01T00:00:00Z";
    results.cells[0].ranked["rmse_debiased"].value = 0.5;
    index.add(results, "newer");
    EXPECT_EQ(index.contents().cells.size(), cells);
    EXPECT_EQ(index.contents().replaced, (std::map<std::string, std::size_t>{{"../nowhere", cells}}));
    EXPECT_EQ(index.contents().cells[0].error, 0.5);
    results.created_utc = "2020-01-01T00:00:00Z";
    results.cells[0].ranked["rmse_debiased"].value = 0.7;
    index.add(results, "oldest");
    EXPECT_EQ(index.contents().cells[0].error, 0.5) << "an earlier one came last";
    EXPECT_EQ(index.contents().replaced.at("../oldest"), cells);
    const std::string page = read_file(write_index_page(index.contents(), testing::output_dir(), "index", 1));
    EXPECT_THAT(page, AllOf(HasSubstr("the newest counts"), HasSubstr("<code>../oldest</code>")));
    results.views[0].radius_m *= 2;
    index.add(results, "nowhere");
    EXPECT_GT(index.contents().cells.size(), cells) << "at another radius it is another view";
}

TEST(Index, ShowsTheLeastErrorOfLightAndKeepsItWhereALaterRunLitNothing) {
    const std::filesystem::path folder = testing::output_dir();
    IndexBuilder index(folder);
    Results results = testing::without_pictures(testing::synthetic_results());
    index.add(results, "nowhere");
    const auto page = [&] { return read_file(write_index_page(index.contents(), folder, "index", 1)); };
    EXPECT_FALSE(index.contents().cells[0].light);
    EXPECT_THAT(page(), Not(HasSubstr("Light is the error of irradiance")));
    Results lit = results;
    lit.created_utc = "2027-01-01T00:00:00Z";
    for (ViewRecord& view : lit.views) view.light.emplace().environment = "court.hdr";
    lit.cells[0].light[light_modes()[0].relative_error()] = {0.3, {}};
    lit.cells[0].light[light_modes()[2].relative_error()] = {0.2, {}};
    index.add(lit, "nowhere");
    results.created_utc = "2028-01-01T00:00:00Z";
    index.add(results, "nowhere");
    const auto& light = index.contents().cells[0].light;
    ASSERT_TRUE(light);
    EXPECT_EQ(light->relative_error, 0.2);
    EXPECT_EQ(light->mode, light_modes()[2].label);
    EXPECT_EQ(light->environment, "court.hdr");
    EXPECT_THAT(page(), HasSubstr("Light is the error of irradiance"));
    EXPECT_THAT(page(), HasSubstr("[20.0,\"bent cone\",\"court.hdr\"]"));
}

TEST(Index, LeadsToThePagesOfTheResultsAndShowsTheirViews) {
    const std::filesystem::path folder = testing::output_dir();
    const std::filesystem::path results = folder / "run of today, 1#";
    testing::write_synthetic(testing::synthetic_results(), results);
    write_page(results);
    IndexBuilder index(folder / "index, not there yet");
    index.add(read_results(results), results);
    for (const IndexedView& view : index.contents().views)
        EXPECT_TRUE(view.picture.starts_with("data:image/png;base64,"));
    for (const IndexedCell& cell : index.contents().cells)
        EXPECT_TRUE(cell.link.starts_with("../run%20of%20today,%201%23/index.html")) << cell.link;
    EXPECT_THAT(index.contents().cells[0].link, HasSubstr("#view=atrium/wide&cell=atrium/wide/"));
}

TEST(Index, SaysThatACameraStandsThereAtSeveralRadii) {
    const std::filesystem::path folder = testing::output_dir();
    IndexBuilder index(folder);
    Results results = testing::without_pictures(testing::synthetic_results());
    index.add(results, "nowhere");
    const auto page = [&] { return read_file(write_index_page(index.contents(), folder, "index", 1)); };
    EXPECT_THAT(page(), Not(HasSubstr("at several radii")));
    results.views[0].radius_m *= 2;
    index.add(results, "nowhere");
    EXPECT_THAT(page(), HasSubstr("1 camera stands here at several radii or sizes"));
}

TEST(Index, ShowsNamesAndReasonsAsTextAlone) {
    const std::filesystem::path folder = testing::output_dir();
    IndexBuilder index(folder);
    Results results = testing::without_pictures(testing::synthetic_results());
    const std::string hostile = "</script><script>alert('x')</script>&{{verdict}}";
    results.cells[0].method_label = hostile;
    results.views[0].scene = hostile;
    index.add(results, "nowhere");
    index.add_unreadable(hostile + "/results.json", hostile);
    const std::string html = read_file(write_index_page(index.contents(), folder, hostile, 1));
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("1 file could not be read"));
    EXPECT_THAT(html, HasSubstr("7 pixels are NaN or infinite")) << "a failed cell lost its reason";
}

}  // namespace
}  // namespace aoscore
