// What the next step from a cell buys, on made-up errors whose differences are known.
#include "verdict/advice.h"

#include "results/advice_text.h"
#include "results/step_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int kBlocks = 100;
constexpr double kBlockPixels = 64;

/// Nine runs of this median.
Timing timed(double ms) {
    Timing timing;
    for (int i = -4; i <= 4; ++i) timing.runs_ms.push_back(ms + 0.001 * i);
    timing.median_ms = ms;
    return timing;
}

/// A cell whose squared errors vary by block, alike for all cells, about `error`.
CellRecord cell(const std::string& name, double error, double ms, double fetches) {
    CellRecord record;
    record.id = "v/" + name;
    record.view_key = "v";
    record.method = record.method_label = name;
    record.preset = "default";
    record.ao = timed(ms);
    record.fixed_pass.median_ms = 2;
    record.fetches_per_pixel = fetches;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> factor(0.5, 1.5);
    BlockErrors& blocks = record.analysis.emplace().blocks;
    double sum = 0;
    for (int i = 0; i < kBlocks; ++i) {
        blocks.counts.push_back(kBlockPixels);
        blocks.squared_sums.push_back(kBlockPixels * error * error * factor(random));
        blocks.variance_sums.push_back(0);
        sum += blocks.squared_sums.back();
    }
    blocks.absolute_sums = blocks.signed_sums = blocks.squared_sums;
    record.analysis->fit.squared_sums = blocks.squared_sums;
    const double rmse = std::sqrt(sum / (kBlocks * kBlockPixels));
    record.ranked = {{"rmse", {rmse, ""}}, {"rmse_debiased", {rmse, ""}}};
    return record;
}

/// Results of a cell and its steps, which are drawn.
struct Made {
    Results results;
    AdvicePlan plan;
    std::vector<std::string> ids;

    explicit Made(const CellRecord& subject) {
        results.views.emplace_back().key = "v";
        results.seed = 1;
        add(subject);
    }
    void add(const CellRecord& one) {
        ids.push_back(one.id);
        results.cells.push_back(one);
    }
    void add_step(const std::string& id, const CellRecord& one) {
        add(one);
        plan.steps.push_back({id, one.id, ids.size() - 1});
    }
    AdviceRecord judged() const { return judge_advice(plan, ids, results); }
};

std::vector<std::string> order_of(const AdviceRecord& advice) {
    std::vector<std::string> order;
    for (const StepRecord& step : advice.steps) order.push_back(step.id + " " + step.verdict);
    return order;
}

TEST(Advice, PutsWhatIsFreeFirstThenWhatAMillisecondBuysAndHarmLast) {
    Made made(cell("subject", 0.1, 10, 16));
    made.add_step("no-filter", cell("harm", 0.12, 8, 16));
    made.add_step("more-taps", cell("dear", 0.06, 30, 32));      // .04 for 20 ms
    made.add_step("guard-band", cell("cheap", 0.08, 12, 16));    // .02 for 2 ms
    made.add_step("tuned-preset", cell("free", 0.095, 10, 16));  // .005 for nothing
    made.add_step("larger-radius", cell("same", 0.1, 20, 16));   // the same picture
    const AdviceRecord advice = made.judged();
    EXPECT_THAT(order_of(advice), ElementsAre("tuned-preset closer", "guard-band closer", "more-taps closer",
                                              "no-filter farther"));
    ASSERT_EQ(advice.skipped.size(), 1U);
    EXPECT_EQ(advice.skipped[0].id, "larger-radius");
    EXPECT_THAT(advice.skipped[0].reason, HasSubstr("changes no pixel"));
    const StepRecord& taps = advice.steps[2];
    EXPECT_NEAR(*bought_per_ms(taps, advice.error), 0.04 / 20, 1e-4);
    EXPECT_NEAR(*bought_per_fetch(taps, advice.error), 0.04 / 16, 1e-4);
    EXPECT_FALSE(bought_per_ms(advice.steps[0], advice.error)) << "it costs nothing that was measured";
}

TEST(Advice, CallsADifferenceThatChanceExplainsATie) {
    Made made(cell("subject", 0.1, 10, 16));
    CellRecord noisy = cell("noisy", 0.1, 10, 16);
    std::mt19937 random(3);
    std::normal_distribution<double> scatter(0, 0.3);
    double sum = 0;
    for (double& squared : noisy.analysis->blocks.squared_sums) {
        squared *= std::exp(scatter(random));
        sum += squared;
    }
    noisy.ranked["rmse_debiased"].value = std::sqrt(sum / (kBlocks * kBlockPixels));
    made.add_step("more-taps", noisy);
    const AdviceRecord advice = made.judged();
    ASSERT_EQ(advice.steps.size(), 1U);
    EXPECT_EQ(advice.steps[0].verdict, StepRecord::kTie);
    EXPECT_TRUE(advice.steps[0].change->holds_zero());
    made.results.advice = {advice};
    EXPECT_THAT(leading_advice(made.results), HasSubstr("No step that was tried surely brings"));
}

TEST(Advice, TakesTheVarianceOverSeedsOffTheSquaredError) {
    Made made(cell("subject", 0.1, 10, 16));
    Repeats& repeats = made.results.cells[0].repeats.emplace();
    for (const double squared : made.results.cells[0].analysis->blocks.squared_sums)
        repeats.variance.push_back(0.36 * squared);
    made.plan.steps.push_back({"no-noise", "", {}});
    const AdviceRecord advice = made.judged();
    ASSERT_EQ(advice.steps.size(), 1U);
    EXPECT_NEAR(*advice.steps[0].error, 0.8 * advice.error, 1e-9);  // sqrt(1 - .36)
    EXPECT_EQ(advice.steps[0].verdict, StepRecord::kCloser);
    EXPECT_FALSE(advice.steps[0].ms) << "nobody has timed it";
}

TEST(Advice, LeavesOutNoiseOfAPictureThatIsTheSameForEverySeed) {
    Made made(cell("subject", 0.1, 10, 16));
    made.results.cells[0].repeats.emplace().variance.assign(kBlocks, 0);
    made.plan.steps.push_back({"no-noise", "", {}});
    const AdviceRecord advice = made.judged();
    EXPECT_TRUE(advice.steps.empty());
    EXPECT_THAT(advice.skipped.at(0).reason, HasSubstr("same for every seed"));
}

TEST(Advice, MeasuresTimeByTheFixedPassThatWasTimedWithEach) {
    Made made(cell("subject", 0.1, 10, 16));
    CellRecord later = cell("later", 0.08, 24, 16);  // the machine was half as fast
    later.fixed_pass.median_ms = 4;
    made.add_step("more-taps", later);
    EXPECT_NEAR(*made.judged().steps.at(0).ms, 2, 1e-9);
}

TEST(Advice, CountsTheGBufferOfAGuardBandAmongItsCost) {
    Made made(cell("subject", 0.1, 10, 16));
    made.results.views[0].gbuffer = timed(5);
    CellRecord wide = cell("wide", 0.08, 12, 16);
    wide.gbuffer = timed(8);
    made.add_step("guard-band", wide);
    EXPECT_NEAR(*made.judged().steps.at(0).ms, 5, 1e-9);
}

TEST(Advice, SaysWhyAStepFailed) {
    Made made(cell("subject", 0.1, 10, 16));
    CellRecord failed = cell("failed", 0.1, 10, 16);
    failed.ranked.clear();
    failed.analysis.reset();
    failed.error = "7 pixels are NaN";
    made.add_step("more-taps", failed);
    const AdviceRecord advice = made.judged();
    EXPECT_THAT(order_of(advice), ElementsAre("more-taps failed"));
    EXPECT_EQ(advice.steps[0].reason, "7 pixels are NaN");
}

/// The same cell with processor time of every run, so many times the clock's.
CellRecord with_processor_time(CellRecord one, double factor) {
    for (const double ms : one.ao.runs_ms) one.ao.processor_runs_ms.push_back(factor * ms);
    one.fixed_pass.runs_ms = one.fixed_pass.processor_runs_ms = {3.9, 4, 4.1};
    return one;
}

// Another load of the machine moves the clock: a step that is said to take longer by it may take less.
TEST(Advice, CostsAreProcessorTimeWhereEveryRunHasIt) {
    Made made(with_processor_time(cell("a", 0.1, 10, 16), 1.5));
    made.add_step("more-taps", with_processor_time(cell("b", 0.05, 30, 32), 0.4));
    const AdviceRecord advice = made.judged();
    EXPECT_NEAR(*advice.ms, 15, 1e-9);
    EXPECT_NEAR(*advice.steps.at(0).ms, 12 - 15, 1e-9);
    EXPECT_NEAR(*advice.fixed_pass_ms, 4, 1e-9);
    Made mixed(with_processor_time(cell("a", 0.1, 10, 16), 1.5));
    mixed.add_step("more-taps", cell("b", 0.05, 30, 32));
    EXPECT_NEAR(*mixed.judged().ms, 10, 1e-9) << "two clocks are never mixed";
}

}  // namespace
}  // namespace aoscore
