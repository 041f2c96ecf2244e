#pragma once

#include "jobs/view_work.h"
#include "stress/stress.h"
#include "stress/stress_axes.h"
#include "stress/stress_subjects.h"

#include <string>
#include <vector>

namespace aoscore {

/// One case with all its runs. It never moves, since the view's work refers to the case.
struct StressWork {
    /// All arguments must outlive it. `key` names it: "tilt/89".
    StressWork(const StressPlan& plan, const std::vector<StressSubject>& subjects, StressCase stress,
               StressJudgement judgement, const std::string& key, SceneTools& tools);
    StressWork(const StressWork&) = delete;
    StressWork& operator=(const StressWork&) = delete;

    /// Adds the runs that the subjects would have in another case, on this one.
    void add_requests(const std::vector<StressSubject>& subjects, const StressCase& as_in);

    StressCase stress;
    StressJudgement judgement;
    std::vector<StressCell> cells;        ///< one for each subject, with the reason where it is not run
    std::vector<StressRequest> requests;  ///< requests of those that are run
    ViewWork view;                        ///< its cells are those of the requests
};

}  // namespace aoscore
