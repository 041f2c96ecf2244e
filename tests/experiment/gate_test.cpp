#include "experiment/gate.h"

#include "core/error.h"

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

}  // namespace
}  // namespace aoscore
