#include "plan/sweep.h"

#include "core/error.h"
#include "metrics/intervals/median_interval.h"
#include "metrics/pareto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class Sweep : public ::testing::Test {
  protected:
    void add(std::vector<std::string> methods, const std::vector<std::string>& axes,
             const std::vector<std::string>& set = {}) {
        SweepRequest request;
        request.methods = std::move(methods);
        for (const std::string& text : axes) request.axes.push_back(parse_axis(text));
        for (const std::string& text : set) request.set.push_back(parse_assignment(text));
        ViewPlan view;
        view.scene = "wall";
        view.view = "facing";
        add_sweep(plan, view, request, sweep, registry);
    }
    std::string error_of(const std::vector<std::string>& methods, const std::vector<std::string>& axes,
                         const std::vector<std::string>& set = {}) {
        try {
            add(methods, axes, set);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
            return e.what();
        }
        ADD_FAILURE() << "no error";
        return "";
    }

    const Registry registry = load_registry();
    ExperimentPlan plan;
    SweepPlan sweep;
};

TEST_F(Sweep, EveryMethodGetsTheProductOfItsAxes) {
    add({"alchemy", "crytek-ssao"}, {"samples=4,8,16", "radius=0.5,1"});
    ASSERT_THAT(plan.views, SizeIs(1));
    EXPECT_THAT(plan.views[0].cells, SizeIs(12));
    EXPECT_THAT(sweep.points, SizeIs(12));
    EXPECT_THAT(sweep.axes, ElementsAre("samples", "radius"));
    EXPECT_EQ(sweep.points[0].at.at("method"), "alchemy");
    EXPECT_EQ(plan.views[0].cells[0].overrides.at("samples"), 4);
    EXPECT_THAT(sweep.notes, SizeIs(0));
}

TEST_F(Sweep, AParameterThatAMethodLacksIsLeftOutForItAndSaid) {
    add({"alchemy", "hbao"}, {"samples=4,8", "directions=2,4,8"});
    EXPECT_THAT(plan.views[0].cells, SizeIs(2 + 3));
    EXPECT_THAT(sweep.notes, ElementsAre(HasSubstr("directions"), HasSubstr("samples")));
}

TEST_F(Sweep, OneSettingThatIsReachedTwiceIsRunOnce) {
    add({"alchemy"}, {"filter=none,normal-depth", "filter.k_n=5,10"});
    EXPECT_THAT(plan.views[0].cells, SizeIs(3)) << "without a filter its parameters do not apply";
    add({"alchemy"}, {"filter=none"});
    EXPECT_THAT(plan.views[0].cells, SizeIs(3));
    EXPECT_THAT(sweep.points, SizeIs(4));
}

TEST_F(Sweep, WhatIsSetReachesTheMethodsAndTheFiltersThatHaveIt) {
    add({"alchemy", "hbao"}, {"filter=none,gaussian-depth"}, {"filter.taps=2", "samples=5"});
    const std::vector<CellPlan>& cells = plan.views.at(0).cells;
    ASSERT_THAT(cells, SizeIs(4));
    for (const CellPlan& cell : cells) {
        EXPECT_EQ(cell.filter_overrides.contains("taps"), *cell.filter == "gaussian-depth")
            << cell_name(cell);
        EXPECT_EQ(cell.overrides.contains("samples"), cell.method == "alchemy") << cell_name(cell);
    }
    EXPECT_EQ(cells[1].filter_overrides.at("taps"), 2);
    EXPECT_EQ(cells[1].overrides.at("samples"), 5);
}

TEST_F(Sweep, WhatIsSetForNothingOrVariedAsWellIsAnError) {
    EXPECT_THAT(error_of({"alchemy"}, {"filter=none"}, {"filter.taps=2"}), HasSubstr("filter.taps"));
    EXPECT_THAT(error_of({"alchemy"}, {"samples=4"}, {"filter.tabs=2"}), HasSubstr("filter.tabs"));
    EXPECT_THAT(error_of({"hbao"}, {"directions=4"}, {"samples=8"}), HasSubstr("samples"));
    EXPECT_THAT(error_of({"alchemy"}, {"samples=4"}, {"sample=8"}), HasSubstr("did you mean samples"));
    EXPECT_THAT(error_of({"alchemy"}, {"samples=4,8"}, {"samples=8"}), HasSubstr("set and varied"));
}

TEST_F(Sweep, SizesAreViewsOfTheirOwn) {
    add({"alchemy"}, {"size=64x48,128x96", "resolution=full,half"});
    ASSERT_THAT(plan.views, SizeIs(2));
    EXPECT_EQ(plan.views[1].width, 128);
    EXPECT_THAT(plan.views[1].cells, SizeIs(2));
}

TEST_F(Sweep, WhatNothingDeclaresIsAnErrorThatListsTheKnown) {
    EXPECT_THAT(error_of({"alchemy"}, {"sample=4"}), HasSubstr("samples"));
    EXPECT_THAT(error_of({"alchemy"}, {"samples=0"}), HasSubstr("from 1"));
    EXPECT_THAT(error_of({"alchemy"}, {"resolution=third"}), HasSubstr("half"));
    EXPECT_THAT(error_of({"alchemy"}, {"size=64"}), HasSubstr("size"));
    EXPECT_THAT(error_of({"alchemy"}, {"filter=blur"}), HasSubstr("box-4x4"));
    for (const char* bad : {"samples", "=4", "samples=", "samples=4,,8", "samples=4,4"})
        EXPECT_THROW(parse_axis(bad), Error) << bad;
}

TEST(Assignment, IsANumberATruthValueOrAWord) {
    EXPECT_EQ(parse_assignment("radius=0.5").parameter, "radius");
    EXPECT_EQ(parse_assignment("radius=0.5").value, 0.5);
    EXPECT_EQ(parse_assignment("filter.slope_correction=false").value, false);
    EXPECT_EQ(parse_assignment("noise=none").value, "none");
    EXPECT_EQ(parse_assignment("noise=null").value, "null") << "no value but a word";
    for (const char* bad : {"radius", "=4", "radius=", ""}) EXPECT_THROW(parse_assignment(bad), Error) << bad;
}

TEST(MedianInterval, NeedsSixRunsAndLiesBetweenTwoOfThem) {
    EXPECT_FALSE(median_interval({1, 2, 3, 4, 5}));
    const auto six = median_interval({6, 1, 3, 2, 5, 4});
    ASSERT_TRUE(six);
    EXPECT_EQ(six->low, 1);
    EXPECT_EQ(six->high, 6);
    // The table of the sign test: with 20 values the 6th and the 15th hold the median with 95.9 %.
    std::vector<double> twenty;
    for (int i = 1; i <= 20; ++i) twenty.push_back(i);
    EXPECT_EQ(median_interval(twenty)->low, 6);
    EXPECT_EQ(median_interval(twenty)->high, 15);
}

TEST(TimingGoal, IsReachedByAgreementOrByTheLastRun) {
    const TimingGoal goal;
    EXPECT_FALSE(goal.reached({10, 10, 10, 10, 10})) << "too few";
    EXPECT_TRUE(goal.reached({10, 10, 10.1, 10, 9.9, 10}));
    EXPECT_FALSE(goal.reached({10, 20, 10, 20, 10, 20}));
    EXPECT_TRUE(goal.reached(std::vector<double>(24, 10.0)));
}

TEST(ParetoFront, HoldsWhatNothingBeatsInBoth) {
    EXPECT_THAT(pareto_front({{1, 5}, {2, 3}, {2, 4}, {3, 3}, {4, 1}, {std::nullopt, 0}, {2, 3}}),
                ElementsAre(true, true, false, false, true, false, true));
}

}  // namespace
}  // namespace aoscore
