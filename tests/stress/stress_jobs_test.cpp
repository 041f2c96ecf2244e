// Tests schedules of stressed views: a mock makes artifacts by recording their names.
#include "stress/stress_jobs.h"

#include "core/error.h"
#include "core/known_names.h"
#include "jobs/executor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MockMaker final : public Maker {
  public:
    bool take(const Job& job) override { return kept.contains(job.key.hex); }
    bool take_input(const Job& job) override { return kept.contains(job.key.hex); }
    void make(const Job& job) override {
        if (job.about == failing && job.kind == ArtifactKind::image) throw internal_error("broken");
        for (const Key& input : job.inputs) EXPECT_TRUE(kept.contains(input.hex));
        made.emplace_back(id_of(job.kind));
        kept.insert(job.key.hex);
    }
    std::vector<std::string> make_in_turns(std::span<const Job* const>) override { return {}; }

    std::set<std::string> kept;
    std::string failing;  ///< the cell whose image fails
    std::vector<std::string> made;
};

class StressedView : public ::testing::Test {
  protected:
    static StressPlan small_plan() {
        StressPlan plan;
        plan.size = 64;
        plan.samples = 4;
        return plan;
    }

    StressWork work(std::string_view axis_id, std::string_view setting_id) {
        const StressAxis& axis = *find_row(stress_axes(), axis_id);
        const StressSetting& setting = *find_row(axis.settings, setting_id);
        return {plan, subjects, stress_case(setting, plan.size), axis.judgement, "test", tools};
    }

    const StressPlan plan = small_plan();
    const Registry registry = load_registry();
    const std::vector<StressSubject> subjects = stress_subjects(registry, {"sao"});
    SceneTools tools;
    Unstressed unstressed{plan, subjects, tools};
};

TEST_F(StressedView, DrawsWhatIsUnstressedFirstAndEverySourceOnce) {
    const StressWork stressed = work("tilt", "89");
    const StressJobs jobs = stress_jobs(stressed, unstressed);
    MockMaker maker;
    execute(jobs.graph, maker);
    ASSERT_GE(maker.made.size(), 7U);
    EXPECT_THAT(std::vector(maker.made.begin(), maker.made.begin() + 5),
                ElementsAre("unstressed", "gbuffer", "truth", "contract", "stress_setting"));
    // Each cell follows the image that it judges, and its times, where it has some, follow the cell.
    std::string before;
    for (const std::string& kind : std::vector(maker.made.begin() + 5, maker.made.end())) {
        if (kind == "stress_cell") {
            EXPECT_EQ(before, "image");
        } else if (kind == "times") {
            EXPECT_EQ(before, "stress_cell");
        }
        before = kind;
    }
    EXPECT_EQ(maker.made[5], "gbuffer_times");
    EXPECT_EQ(std::ranges::count(maker.made, "stress_cell"), std::ssize(subjects));
}

TEST_F(StressedView, TracesNothingWhereAPictureIsTooLargeForIt) {
    const StressWork stressed = work("size", "4096x4096");
    const StressJobs jobs = stress_jobs(stressed, unstressed);
    MockMaker maker;
    execute(jobs.graph, maker);
    EXPECT_EQ(std::ranges::count(maker.made, "truth"), 0);
    EXPECT_EQ(std::ranges::count(maker.made, "gbuffer"), 1);
}

TEST_F(StressedView, MakesNothingWhereEverythingIsThere) {
    const StressWork stressed = work("tilt", "89");
    const StressJobs jobs = stress_jobs(stressed, unstressed);
    MockMaker maker;
    for (const Key& key : jobs.graph.wanted()) maker.kept.insert(key.hex);
    execute(jobs.graph, maker);
    EXPECT_THAT(maker.made, IsEmpty());
}

TEST_F(StressedView, IsWholeWithoutItsTimes) {
    const StressWork stressed = work("tilt", "89");
    const StressJobs jobs = stress_jobs(stressed, unstressed);
    MockMaker maker;
    ExecutionOptions options;
    options.times = false;
    const Execution done = execute(jobs.graph, maker, options);
    EXPECT_EQ(std::ranges::count(maker.made, "stress_cell"), std::ssize(subjects));
    EXPECT_EQ(std::ranges::count(maker.made, "times"), 0);
    EXPECT_FALSE(done.left_out.empty());
    EXPECT_TRUE(done.failed.empty());
}

TEST_F(StressedView, LosesNoMoreThanTheCellOfAnImageThatFails) {
    const StressWork stressed = work("tilt", "89");
    const StressJobs jobs = stress_jobs(stressed, unstressed);
    MockMaker maker;
    maker.failing = "stress test/sao";
    const Execution done = execute(jobs.graph, maker);
    EXPECT_EQ(std::ranges::count(maker.made, "stress_cell"), std::ssize(subjects) - 1);
    for (std::size_t i = 0; i < jobs.cells.size(); ++i)
        EXPECT_EQ(done.has_failed(jobs.cells[i]), stressed.requests[i].subject->id == "sao");
}

// A cell does not depend on the other subjects, nor on the number of settings.
TEST_F(StressedView, GivesASubjectTheSameKeysWhoeverIsTriedBesideIt) {
    const std::vector<StressSubject> others = stress_subjects(registry, {"sao", "hbao"});
    const Unstressed with_others(plan, others, tools);
    const auto key_of_sao = [](const StressWork& work, const Unstressed& base) {
        const StressJobs jobs = stress_jobs(work, base);
        for (std::size_t i = 0; i < jobs.cells.size(); ++i) {
            if (work.requests[i].subject->id == "sao") return jobs.cells[i].hex;
        }
        return std::string();
    };
    const StressAxis& tilt = *find_row(stress_axes(), "tilt");
    const StressWork more(plan, others, stress_case(tilt.settings[2], plan.size), tilt.judgement, "more",
                          tools);
    const StressWork alone(plan, subjects, stress_case(tilt.settings[2], plan.size), tilt.judgement, "alone",
                           tools);
    const StressWork elsewhere(plan, subjects, stress_case(tilt.settings[3], plan.size), tilt.judgement,
                               "elsewhere", tools);
    EXPECT_NE(key_of_sao(alone, unstressed), "");
    EXPECT_EQ(key_of_sao(alone, unstressed), key_of_sao(more, with_others));
    EXPECT_NE(key_of_sao(alone, unstressed), key_of_sao(elsewhere, unstressed));
}

}  // namespace
}  // namespace aoscore
