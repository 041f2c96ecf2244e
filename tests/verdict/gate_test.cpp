#include "verdict/gate.h"

#include "core/error.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/metric.h"
#include "metrics/signal_metric.h"
#include "results/light_modes.h"
#include "verdict/gates.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

const MetricMap kMeasured{{"rmse", {0.03, ""}}, {"ssim", {0.9, ""}}, {"psnr", {std::nullopt, "identical"}}};

TEST(Gate, TripsExactlyWhenTheStatedRelationHolds) {
    EXPECT_TRUE(Gate::parse("rmse>0.02").tripped_by(kMeasured));
    EXPECT_FALSE(Gate::parse("rmse>0.03").tripped_by(kMeasured));
    EXPECT_TRUE(Gate::parse("rmse>=0.03").tripped_by(kMeasured));
    EXPECT_TRUE(Gate::parse("ssim<0.95").tripped_by(kMeasured));
    EXPECT_FALSE(Gate::parse("ssim<=0.85").tripped_by(kMeasured));
}

TEST(Gate, AValueThatCouldNotBeHadTripsEveryGate) {
    EXPECT_TRUE(Gate::parse("psnr<1").tripped_by(kMeasured));
    EXPECT_TRUE(Gate::parse("psnr>1").tripped_by(kMeasured));
    EXPECT_TRUE(Gate::parse("mae>1").tripped_by({})) << "a metric that was not measured";
}

TEST(Gate, ExplanationNamesTheMeasuredValueAndWhatWouldHavePassed) {
    const std::string line = Gate::parse("rmse>0.02").explain(kMeasured);
    EXPECT_THAT(line, HasSubstr("rmse is 0.03"));
    EXPECT_THAT(line, HasSubstr("would have passed"));
}

TEST(Gate, MalformedLimitsAreUsageErrors) {
    for (const char* text : {"rmse", "rmse>", "rmse>x", "rmse>nan", "rmse>0.1x", "nonsense>1", ">1"}) {
        try {
            Gate::parse(text);
            ADD_FAILURE() << text << " was accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage) << text;
        }
    }
}

TEST(Gate, TakesEveryRowOfTheTableAndTheAreas) {
    for (const Metric& row : metrics()) EXPECT_EQ(Gate::parse(std::string(row.id) + ">0.5").metric, row.id);
    for (const MaskArea& area : mask_areas())
        EXPECT_EQ(Gate::parse(std::string(area.id) + ">0.5").metric, area.id);
}

TEST(Gate, TakesEveryMetricOfASignalAndEveryErrorOfLight) {
    CellRecord cell;
    double next = 1;
    std::vector<std::string> ids;
    for (const SignalMetric& row : signal_metrics()) {
        cell.signals[std::string(row.signal)][std::string(row.id)].value = ++next;
        ids.emplace_back(row.id);
    }
    for (const LightMode& mode : light_modes()) {
        for (const std::string& id : mode.measures()) {
            cell.light[id].value = ++next;
            ids.push_back("light." + id);
        }
    }
    double value = 1;
    for (const std::string& id : ids) {
        const auto trips = [&](double limit) {
            return Gate::parse(fmt::format("{}>{}", id, limit)).tripped_by(limited_measures(cell));
        };
        ++value;
        EXPECT_TRUE(trips(value - 0.5)) << id;
        EXPECT_FALSE(trips(value + 0.5)) << id;
        const Gate gate = Gate::parse(id + ">0.5");
        const MetricMap unmeasured = limited_measures(CellRecord());
        EXPECT_TRUE(gate.tripped_by(unmeasured)) << id;
        EXPECT_THAT(gate.explain(unmeasured), HasSubstr("it is measured by score --")) << id;
    }
}

TEST(Gates, DoNotHoldMethodsToSignalsThatTheyDoNotGive) {
    CellRecord with, without;
    with.light["relative_rmse.cone"].value = 0.3;
    const Gates gates({"light.relative_rmse.cone>0.2", "rmse>0.02"}, {}, false);
    const std::set<std::string> measured = {"light.relative_rmse.cone"};
    EXPECT_EQ(gates.check(limited_measures(with), measured).failures.size(), 2u);
    const Gates::Tripped tripped = gates.check(limited_measures(without), measured);
    ASSERT_EQ(tripped.failures.size(), 1u) << "a missing RMSE is a failure of every method";
    EXPECT_THAT(tripped.failures[0], HasSubstr("rmse"));
    EXPECT_THAT(gates.not_judging(limited_measures(without), measured),
                ::testing::ElementsAre("light.relative_rmse.cone>0.2"));
    EXPECT_THAT(gates.not_judging(limited_measures(with), measured), ::testing::IsEmpty());
    // Where no cell has the value, nothing was measured, and a gate must not pass.
    EXPECT_EQ(gates.check(limited_measures(without), {}).failures.size(), 2u);
}

TEST(Gates, RefuseALimitBelowTheNoiseWhereTheRowSaysThatNoiseAdds) {
    for (const Metric& row : metrics()) {
        const Gates gates({std::string(row.id) + ">0.01"}, {}, false);
        EXPECT_NO_THROW(gates.require_above_noise(0.005, "truth")) << row.id;
        if (row.without_noise.empty()) {
            EXPECT_NO_THROW(gates.require_above_noise(0.02, "truth")) << row.id;
            continue;
        }
        try {
            gates.require_above_noise(0.02, "truth");
            ADD_FAILURE() << row.id;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
            EXPECT_THAT(e.what(), HasSubstr(std::string(row.without_noise)));
        }
    }
}

}  // namespace
}  // namespace aoscore
