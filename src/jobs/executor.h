#pragma once

#include "jobs/job.h"

#include <functional>
#include <optional>
#include <string>

namespace aoscore {

/// Makes artifacts, or takes those that are there. Behind it: ViewMaker, which draws and traces, and the mock
/// of the tests.
class Maker {
  public:
    virtual ~Maker() = default;

    /// Brings an artifact that was made before to where it is asked for; false where there is none.
    virtual bool take(const Job& job) = 0;
    /// The same for an input of a job that is about to be made.
    virtual bool take_input(const Job& job) = 0;
    /// Makes a job's artifact; all its inputs are at hand. Throws where it fails.
    virtual void make(const Job& job) = 0;
    /// Makes jobs of one kind in turns. An entry of the answer is why that job failed, empty where it did
    /// not.
    virtual std::vector<std::string> make_in_turns(std::span<const Job* const> jobs) = 0;
};

/// What became of a plan's jobs.
struct Execution {
    std::map<Key, std::string> failed;  ///< why; of jobs that were tried, and of those that needed them
    std::vector<Key> taken, made;       ///< in that order

    bool has_failed(const Key& key) const { return failed.contains(key); }
};

struct ExecutionOptions {
    /// How many jobs are made in turns at first; later groups follow how long one takes (next_group()).
    /// Empty: all that there are.
    std::optional<std::size_t> first_group;
    /// Called before each job that is made, or the first of those that are made in turns.
    std::function<void(const Job& job)> on_begin;
    /// Called after each job that was made or failed.
    std::function<void(const Job& job)> on_end;
};

/// Takes every artifact that the graph asks for, or makes it: in the order in which they are asked for,
/// inputs first, each once. A job that fails is remembered, and the rest goes on; only the failure of an
/// essential one ends all, by its exception. Throws interrupted_error on Ctrl-C; what was made until then is
/// kept.
Execution execute(const JobGraph& graph, Maker& maker, const ExecutionOptions& options = {});

}  // namespace aoscore
