// The section of next steps says what each costs and buys, and never divides by nothing.
#include "page/section.h"
#include "page/synthetic_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

class AdviceSection : public ::testing::Test {
  protected:
    Results results = testing::synthetic_results();
    Pictures pictures;
    LiveData live;
    PageSource source() const { return {results, pictures, live}; }
    static std::string text(const nlohmann::json& step, std::size_t column) {
        return step.at("numbers").at(column).at("text").get<std::string>();
    }
};

TEST_F(AdviceSection, DividesTheErrorThatAStepTakesOffByWhatItCosts) {
    const nlohmann::json step =
        section::advice(source()).at("views").at(0).at("cells").at(0).at("steps").at(0);
    EXPECT_EQ(text(step, 0), "0.0800");
    EXPECT_EQ(text(step, 1), "−0.0250 to −0.0150");
    EXPECT_EQ(text(step, 2), "+4.00");
    EXPECT_EQ(text(step, 3), "+2.00") << "in fixed passes of 2 ms";
    EXPECT_EQ(text(step, 4), "0.00500") << ".02 for 4 ms";
    EXPECT_EQ(text(step, 6), "0.00125") << ".02 for 16 fetches";
}

TEST_F(AdviceSection, ShowsADashWhereNothingWasMeasuredOrNothingIsPaid) {
    const nlohmann::json steps = section::advice(source()).at("views").at(0).at("cells").at(0).at("steps");
    EXPECT_EQ(text(steps.at(1), 4), "–");
    EXPECT_EQ(text(steps.at(1), 6), "–") << "it takes no more fetches";
    EXPECT_EQ(text(steps.at(2), 0), "–");
    EXPECT_EQ(steps.at(2).at("verdict"), StepRecord::kFailed);
}

TEST_F(AdviceSection, LeavesOneSentenceInTheVerdict) {
    const nlohmann::json verdict = section::verdict(source());
    std::size_t sentences = 0;
    for (const auto& detail : verdict.at("details"))
        sentences += detail.get<std::string>().starts_with("The best next step for ") ? 1 : 0;
    EXPECT_EQ(sentences, 1U);
    EXPECT_THAT(section::advice(source()).at("in_short").get<std::string>(),
                HasSubstr("it takes 0.0200 off an error of 0.1000, for 4.00 ms more"));
}

}  // namespace
}  // namespace aoscore
