#include "verdict/gate.h"

#include "core/error.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/metric.h"
#include "verdict/gates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
