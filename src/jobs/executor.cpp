#include "jobs/executor.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/stopwatch.h"
#include "jobs/timing.h"

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

class Executor {
  public:
    Executor(const JobGraph& graph, Maker& maker, const ExecutionOptions& options)
        : graph_(graph), maker_(maker), options_(options) {}

    Execution run() {
        std::vector<const Job*> pending, in_turns;
        for (const Key& key : graph_.wanted()) {
            const Job& job = graph_.at(key);
            if (maker_.take(job)) {
                done_.taken.push_back(key);
            } else if (is_of_times(job.kind) && !options_.times) {
                done_.left_out.push_back(key);
            } else {
                (job.in_turns ? in_turns : pending).push_back(&job);
            }
        }
        for (const Job* job : pending) make(*job);
        make_in_turns(in_turns);
        return std::move(done_);
    }

  private:
    /// Makes the job's inputs where they are missing. False where one of them failed, and the job with it.
    bool prepare(const Job& job) {
        for (const Key& key : job.after) {
            if (done_.has_failed(key)) return fail(job, done_.failed.at(key));
        }
        for (const Key& key : job.inputs) {
            const Job& input = graph_.at(key);
            if (!done_.has_failed(key) && !maker_.take_input(input)) make(input);
            if (done_.has_failed(key)) return fail(job, done_.failed.at(key));
        }
        return true;
    }

    bool fail(const Job& job, const std::string& why) {
        done_.failed.emplace(job.key, why);
        return false;
    }

    void announce(const Job& job) {
        throw_if_interrupted();
        if (options_.on_begin) options_.on_begin(job);
    }

    void make(const Job& job) {
        if (done_.has_failed(job.key) || !prepare(job)) return;
        announce(job);
        try {
            maker_.make(job);
            done_.made.push_back(job.key);
        } catch (const Error& e) {
            // When one artifact fails, the others are still made.
            if (job.essential || e.exit_code() == ExitCode::interrupted) throw;
            fail(job, e.what());
        }
        if (options_.on_end) options_.on_end(job);
    }

    void make_in_turns(std::vector<const Job*> jobs) {
        std::erase_if(jobs, [&](const Job* job) { return !prepare(*job); });
        std::size_t together = options_.first_group.value_or(jobs.size());
        for (std::span<const Job* const> rest = jobs; !rest.empty();) {
            const auto group = rest.first(std::min(together, rest.size()));
            announce(*group.front());
            const Stopwatch watch;
            const std::vector<std::string> errors = maker_.make_in_turns(group);
            for (std::size_t i = 0; i < group.size(); ++i) {
                if (errors[i].empty()) {
                    done_.made.push_back(group[i]->key);
                } else {
                    fail(*group[i], errors[i]);
                }
            }
            together = next_group(together, watch.seconds());
            rest = rest.subspan(group.size());
        }
    }

    const JobGraph& graph_;
    Maker& maker_;
    const ExecutionOptions& options_;
    Execution done_;
};

}  // namespace

Execution execute(const JobGraph& graph, Maker& maker, const ExecutionOptions& options) {
    return Executor(graph, maker, options).run();
}

}  // namespace aoscore
