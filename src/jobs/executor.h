#pragma once

#include "jobs/job.h"

#include <functional>
#include <optional>
#include <string>

namespace aoscore {

/// Makes artifacts, or takes those that are there. Implementations are ViewMaker, which draws and traces, and
/// the mock of the tests.
class Maker {
  public:
    virtual ~Maker() = default;

    /// Takes a stored artifact for the results; false where there is none.
    virtual bool take(const Job& job) = 0;
    /// Takes an input of a job that is about to be made from memory or the store; false where there is
    /// none.
    virtual bool take_input(const Job& job) = 0;
    /// Makes a job's artifact; all its inputs are at hand. Throws where it fails.
    virtual void make(const Job& job) = 0;
    /// Makes jobs of one kind in turns. Each entry of the result says why that job failed; empty where it did
    /// not.
    virtual std::vector<std::string> make_in_turns(std::span<const Job* const> jobs) = 0;
};

/// The outcome of a plan's jobs.
struct Execution {
    std::map<Key, std::string> failed;  ///< reasons, for failed jobs and for jobs that needed them
    std::vector<Key> taken, made;       ///< in order of time
    std::vector<Key> left_out;          ///< times that were not to be taken

    bool has_failed(const Key& key) const { return failed.contains(key); }
};

struct ExecutionOptions {
    /// Whether times may be taken here; else only those that are there count.
    bool times = true;
    /// The number of jobs in the first group that is made in turns; the size of later ones follows the time
    /// it took (next_group()). Empty: all jobs are one group.
    std::optional<std::size_t> first_group;
    /// Called before each job that is made, and before the first job of a group in turns.
    std::function<void(const Job& job)> on_begin;
    /// Called after each job that was made or failed.
    std::function<void(const Job& job)> on_end;
};

/// Takes or makes every artifact that the graph asks for, in the order of asking, inputs first, each once. A
/// job that fails is remembered, and the rest goes on; only the failure of an essential job ends all, by its
/// exception. Throws interrupted_error on Ctrl-C; the artifacts made by then are kept.
Execution execute(const JobGraph& graph, Maker& maker, const ExecutionOptions& options = {});

}  // namespace aoscore
