// The page of a tuning says what was in sample and what was held out, and its front is one.
#include "core/error.h"
#include "core/files.h"
#include "page/tuning_front.h"
#include "page/tuning_page.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

BudgetRecord budget(std::optional<double> most_fetches, double fetches, double loss, double change) {
    BudgetRecord b;
    b.most_fetches = most_fetches;
    b.preset_id = most_fetches ? "tuned-" + std::to_string(static_cast<int>(*most_fetches)) : "tuned";
    b.settings = {{"bias", 0.25}};
    b.published = {0.2, 16, {}, {0.1, 0.3}};
    b.tuned = {loss, fetches, {}, {loss, loss}};
    b.held_out = {
        {"view", loss + 0.01, change, {change - 0.01, change + 0.01}, change < -0.01 ? "closer" : "tie"}};
    b.worth = {{"bias", 0.1, 0.25, loss, 0.2}};
    return b;
}

TuningRecord synthetic_tuning() {
    TuningRecord tuning;
    tuning.program_version = "1";
    tuning.created_utc = "2026-01-02T03:04:05Z";
    tuning.command = "aoscore tune <scene>";
    tuning.metric = "rmse_debiased";
    tuning.size = {96, 54};
    tuning.rays_a_pixel = 16;
    tuning.views = {{"<i>pillar</i>/main", 0.5}, {"pillar/moved", 0.5}};
    tuning.methods = {{"hbao",
                       "HBAO",
                       "default",
                       5,
                       7,
                       {budget(24, 24, 0.08, -0.1), budget(48, 48, 0.09, -0.1), budget(8, 8, 0.15, -0.005)}}};
    return tuning;
}

std::filesystem::path written(const TuningRecord& tuning) {
    const auto folder = testing::output_dir();
    write_tuning_record(tuning, folder);
    for (const MethodTuningRecord& method : tuning.methods)
        write_atomically(folder / preset_file_name(method.method), "{\"presets\": \"</pre><b>\"}");
    return folder;
}

TEST(TuningPage, StatesVerdictsOfWhatWasHeldOut) {
    const std::string html = read_file(write_tuning_page(written(synthetic_tuning())));
    EXPECT_THAT(
        html,
        HasSubstr(
            "On what was left out, the tuned settings of HBAO (tuned-24) and HBAO (tuned-48) are closer to "
            "the truth than the published ones; those of HBAO (tuned-8) tie with the published ones."));
    EXPECT_THAT(
        html,
        HasSubstr("<td class=\"ours\">0.0900</td><td>+0.0100</td><td>−0.1000 (−0.1100 to −0.0900)</td>"));
}

TEST(TuningPage, SaysThatNothingIsKnownOfOtherViewsWhereNothingWasHeldOut) {
    TuningRecord tuning = synthetic_tuning();
    for (BudgetRecord& b : tuning.methods[0].budgets) b.held_out.clear();
    const std::string html = read_file(write_tuning_page(written(tuning)));
    EXPECT_THAT(html, HasSubstr("Nothing was left out"));
    EXPECT_THAT(html, HasSubstr("in sample alone"));
}

TEST(TuningPage, EscapesWhatCameFromFiles) {
    const std::string html = read_file(write_tuning_page(written(synthetic_tuning())));
    EXPECT_THAT(html, Not(HasSubstr("<i>pillar")));
    EXPECT_THAT(html, Not(HasSubstr("</pre><b>")));
    EXPECT_THAT(html, HasSubstr("&lt;i&gt;pillar"));
}

TEST(TuningPage, HasOnItsFrontWhatNothingBeatsAtAsFewFetches) {
    std::vector<std::string> front;
    const std::vector<TunedPoint> points = tuned_points(synthetic_tuning());
    ASSERT_EQ(points.size(), 4U) << "the published settings and those of three budgets";
    for (const TunedPoint& point : points) {
        if (point.on_front) front.push_back(point.name);
    }
    EXPECT_THAT(front, ::testing::ElementsAre("HBAO, tuned-24", "HBAO, tuned-8"));
}

TEST(TuningPage, IsRefusedForAnotherVersionAndForNumbersThatDoNotBelongTogether) {
    const auto folder = written(synthetic_tuning());
    const std::string text = read_file(folder / "tune.json");
    std::string other = text;
    other.replace(other.find("\"schema_version\": 2"), 19, "\"schema_version\": 1");
    write_atomically(folder / "tune.json", other);
    EXPECT_THROW(write_tuning_page(folder), Error);
    TuningRecord tuning = synthetic_tuning();
    tuning.views.pop_back();
    write_tuning_record(tuning, folder);
    EXPECT_THROW(write_tuning_page(folder), Error);
}

}  // namespace
}  // namespace aoscore
