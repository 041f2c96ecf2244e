// Tests schedules without OpenGL or Embree: a mock makes artifacts by recording their names.
#include "jobs/executor.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

/// Keeps its artifacts under the jobs' keys; `failing` jobs throw.
class MockMaker final : public Maker {
  public:
    bool take(const Job& job) override { return kept.contains(job.key.hex); }
    bool take_input(const Job& job) override { return kept.contains(job.key.hex); }
    void make(const Job& job) override {
        if (failing.contains(job.key.hex)) throw internal_error("broken " + job.key.hex);
        if (interrupted_at == job.key.hex) throw interrupted_error();
        for (const Key& input : job.inputs) EXPECT_TRUE(kept.contains(input.hex)) << input.hex;
        made.push_back(job.key.hex);
        kept.insert(job.key.hex);
    }
    std::vector<std::string> make_in_turns(std::span<const Job* const> jobs) override {
        std::string group;
        std::vector<std::string> errors;
        for (const Job* job : jobs) {
            group += job->key.hex;
            errors.push_back(failing.contains(job->key.hex) ? "broken" : "");
            if (errors.back().empty()) kept.insert(job->key.hex);
        }
        made.push_back(group);
        return errors;
    }

    std::set<std::string> kept, failing;
    std::string interrupted_at;
    std::vector<std::string> made;
};

Job job(std::string key, std::vector<Key> inputs = {}) {
    Job job;
    job.key = {std::move(key)};
    job.inputs = std::move(inputs);
    return job;
}

TEST(Executor, MakesInputsFirstAndEachJobOnce) {
    JobGraph graph;
    graph.add(job("gbuffer"));
    graph.add(job("truth"));
    graph.add(job("image", {{"gbuffer"}}));
    graph.want(job("score", {{"image"}, {"truth"}}));
    graph.want(job("own", {{"image"}, {"truth"}}));
    graph.want(job("score", {{"image"}, {"truth"}}));
    MockMaker maker;
    execute(graph, maker);
    EXPECT_THAT(maker.made, ElementsAre("gbuffer", "image", "truth", "score", "own"));
}

TEST(Executor, MakesNothingThatNobodyAsksFor) {
    JobGraph graph;
    graph.add(job("gbuffer"));
    graph.add(job("unused", {{"gbuffer"}}));
    graph.want(job("score"));
    MockMaker maker;
    execute(graph, maker);
    EXPECT_THAT(maker.made, ElementsAre("score"));
}

TEST(Executor, TakesWhatIsThereAndThenNeedsNoInputsOfIt) {
    JobGraph graph;
    graph.add(job("truth"));
    graph.want(job("score", {{"truth"}}));
    MockMaker maker;
    maker.kept = {"score"};
    const Execution done = execute(graph, maker);
    EXPECT_THAT(maker.made, IsEmpty());
    EXPECT_THAT(done.taken, ElementsAre(Key{"score"}));
}

TEST(Executor, AFailureReachesWhatStandsOnItAndNothingElse) {
    JobGraph graph;
    graph.add(job("bad"));
    graph.add(job("good"));
    graph.want(job("a", {{"bad"}}));
    Job after = job("times of a");
    after.after = {{"a"}};
    graph.want(after);
    graph.want(job("b", {{"good"}}));
    MockMaker maker;
    maker.failing = {"bad"};
    const Execution done = execute(graph, maker);
    EXPECT_THAT(maker.made, ElementsAre("good", "b"));
    EXPECT_THAT(done.failed, ElementsAre(Pair(Key{"a"}, "broken bad"), Pair(Key{"bad"}, "broken bad"),
                                         Pair(Key{"times of a"}, "broken bad")));
}

TEST(Executor, LeavesTimesOutWhereNoneMayBeTakenAndTakesThoseThatAreThere) {
    JobGraph graph;
    graph.add(job("image"));
    Job kept = job("times of a", {{"image"}}), missing = job("times of b", {{"image"}}),
        gbuffer = job("times of the gbuffer");
    kept.kind = missing.kind = ArtifactKind::times;
    kept.in_turns = missing.in_turns = true;
    gbuffer.kind = ArtifactKind::gbuffer_times;
    for (const Job& timed : {kept, missing, gbuffer}) graph.want(timed);
    MockMaker maker;
    maker.kept = {"times of a"};
    ExecutionOptions options;
    options.times = false;
    const Execution done = execute(graph, maker, options);
    EXPECT_THAT(maker.made, IsEmpty());
    EXPECT_THAT(done.taken, ElementsAre(Key{"times of a"}));
    EXPECT_THAT(done.left_out, ElementsAre(Key{"times of b"}, Key{"times of the gbuffer"}));
    EXPECT_THAT(done.failed, IsEmpty());
}

TEST(Executor, AFailureOfAnEssentialJobEndsAll) {
    JobGraph graph;
    Job truth = job("truth");
    truth.essential = true;
    graph.add(truth);
    graph.want(job("a", {{"truth"}}));
    MockMaker maker;
    maker.failing = {"truth"};
    EXPECT_THROW(execute(graph, maker), Error);
}

TEST(Executor, GoesOnAfterAnInterruptWhereItWas) {
    JobGraph graph;
    for (const char* name : {"a", "b", "c"}) graph.want(job(name));
    MockMaker maker;
    maker.interrupted_at = "b";
    EXPECT_THROW(execute(graph, maker), Error);
    maker.interrupted_at.clear();
    execute(graph, maker);
    EXPECT_THAT(maker.made, ElementsAre("a", "b", "c"));
}

TEST(Executor, MakesTimesInTurnsAfterAllElseAndInGroups) {
    JobGraph graph;
    graph.add(job("g"));
    for (const char* name : {"1", "2", "3", "4", "5"}) {
        Job times = job(name, {{"g"}});
        times.in_turns = true;
        graph.want(times);
    }
    graph.want(job("score"));
    MockMaker maker;
    maker.failing = {"3"};
    ExecutionOptions options;
    options.first_group = 2;
    const Execution done = execute(graph, maker, options);
    // A quick group is followed by one twice as large.
    EXPECT_THAT(maker.made, ElementsAre("score", "g", "12", "345"));
    EXPECT_THAT(done.failed, ElementsAre(Pair(Key{"3"}, "broken")));
}

}  // namespace
}  // namespace aoscore
