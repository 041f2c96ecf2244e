// Tests score --signals: its scores, its files, its refusals.
#include "core/files.h"
#include "core/signal.h"
#include "image/image_file.h"
#include "metrics/signal_metric.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScore = "score sphere --size 64x36 --samples 16 --no-cache --filter none ";

TEST(ScoreOfSignals, HoldsThemAgainstTheTruthByAngleAndLeavesVisibilityAsItWas) {
    const auto folder = output_dir();
    const auto plain = run_aoscore(std::string(kScore) + "--methods gtao,alchemy --out plain", folder);
    ASSERT_EQ(plain.exit_code, 0) << plain.err;
    const auto run = run_aoscore(std::string(kScore) +
                                     "--methods gtao,alchemy --signals bent_normal,cone_angle "
                                     "--export s.csv --out page",
                                 folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("no bent_normal is scored of alchemy"));
    const Results before = read_results(folder / "plain"), results = read_results(folder / "page");
    for (const CellRecord& cell : results.cells) {
        EXPECT_EQ(cell.signals.size(), cell.method == "gtao" ? 2u : 0u) << cell.id;
        for (const SignalMetric& metric : signal_metrics()) {
            if (cell.method != "gtao") continue;
            const auto& value = cell.signals.at(std::string(metric.signal)).at(std::string(metric.id)).value;
            ASSERT_TRUE(value) << metric.id;
            EXPECT_LT(*value, 45) << metric.id;
        }
    }
    for (std::size_t i = 0; i < results.cells.size(); ++i) {
        const ImageFile a = read_image(folder / "plain" / before.cells[i].image_file),
                        b = read_image(folder / "page" / results.cells[i].image_file);
        EXPECT_EQ(a.channel("Y")->pixels, b.channel("Y")->pixels) << results.cells[i].id;
    }
    const ImageFile truth = read_image(folder / "page" / results.views.front().truth_file);
    for (const std::string& id : further_signals()) {
        for (const std::string_view channel : signal(id).channels)
            EXPECT_NE(truth.channel(std::string(channel)), nullptr) << channel;
        EXPECT_NE(truth.channel(std::string(signal(id).error_channel)), nullptr) << id;
    }
    ASSERT_EQ(results.views.front().signals.size(), further_signals().size());
    EXPECT_GT(results.views.front().signals.front().known_pixels, 100u);
    EXPECT_TRUE(before.views.front().signals.empty());
}

TEST(ScoreOfSignals, OfFewRaysSayThatTheyAreNotKnown) {
    const auto folder = output_dir();
    const std::string command =
        "score pillar --view main --size 64x36 --methods gtao,hbao --no-cache --signals ";
    const auto none = run_aoscore(command + "cone_angle --samples 2 --out none", folder);
    ASSERT_EQ(none.exit_code, 0) << none.err;
    EXPECT_THAT(none.err, HasSubstr("the truth of cone_angle is certain enough in only 0.0 % of the pixels"));
    EXPECT_THAT(read_file(folder / "none" / "index.html"), HasSubstr("too few rays to know these signals"));
    const auto many = run_aoscore(command + "cone_angle --samples 1024 --out many", folder);
    EXPECT_THAT(many.err, Not(HasSubstr("certain enough")));
}

TEST(ScoreOfSignals, RefusesWhatNoMethodGives) {
    const auto folder = output_dir();
    const auto none =
        run_aoscore(std::string(kScore) + "--methods alchemy --signals bent_normal --out a", folder);
    EXPECT_EQ(none.exit_code, 64);
    EXPECT_THAT(none.err, HasSubstr("gtao"));
    const auto unknown = run_aoscore(std::string(kScore) + "--methods gtao --signals colour --out b", folder);
    EXPECT_EQ(unknown.exit_code, 64);
    EXPECT_THAT(unknown.err, HasSubstr("bent_normal"));
}

TEST(ScoreOfSignals, IsRefusedBeforeTheWorkWhereAResolutionGivesNone) {
    const auto folder = output_dir();
    for (const char* resolution : {"half", "dual"}) {
        const auto run = run_aoscore(
            "score wall --view facing --size 48x32 --samples 4 --methods gtao --signals "
            "bent_normal --out out --resolution " +
                std::string(resolution),
            folder);
        EXPECT_EQ(run.exit_code, 64) << run.err;
        EXPECT_THAT(run.err, HasSubstr("--resolution full or half-gbuffer"));
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

TEST(ScoreOfSignals, IsTakenFromWhatIsKept) {
    const auto folder = output_dir();
    const std::string command = "score sphere --size 48x27 --samples 16 --methods gtao --signals cone_angle ";
    const auto first = run_aoscore(command + "--out a", folder),
               again = run_aoscore(command + "--out b", folder);
    ASSERT_EQ(again.exit_code, 0) << again.err;
    const CellRecord a = read_results(folder / "a").cells.front(),
                     b = read_results(folder / "b").cells.front();
    EXPECT_EQ(a.signals.at("cone_angle").at("cone_error_mean").value,
              b.signals.at("cone_angle").at("cone_error_mean").value);
    EXPECT_EQ(read_results(folder / "b").work.passes, 0u);
}

}  // namespace
}  // namespace aoscore
