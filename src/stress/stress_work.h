#pragma once

#include "jobs/view_work.h"
#include "stress/stress.h"
#include "stress/stress_axes.h"
#include "stress/stress_subjects.h"

#include <string>
#include <vector>

namespace aoscore {

/// One case with all that is run on it. Stays where it is made: the view's work refers to the case.
struct StressWork {
    /// All that it refers to must outlive it. `key` names it: "tilt/89".
    StressWork(const StressPlan& plan, const std::vector<StressSubject>& subjects, StressCase stress,
               StressJudgement judgement, const std::string& key, SceneTools& tools);
    StressWork(const StressWork&) = delete;
    StressWork& operator=(const StressWork&) = delete;

    /// Also what the subjects would be run as in another case, on this one.
    void add_requests(const std::vector<StressSubject>& subjects, const StressCase& as_in);

    StressCase stress;
    StressJudgement judgement;
    std::vector<StressCell> cells;        ///< one a subject, with why it is not run where it is not
    std::vector<StressRequest> requests;  ///< of those that are run
    ViewWork view;                        ///< its cells are the requests'
};

}  // namespace aoscore
