#pragma once

#include "plan/resolved_cell.h"
#include "store/artifact_store.h"
#include "stress/stress.h"
#include "stress/stress_axes.h"
#include "stress/stress_jobs.h"
#include "stress/unstressed.h"

#include <functional>
#include <string>
#include <vector>

namespace aoscore {

/// The settings of a stress plan in the order of running, and the data that all of them share.
class StressSchedule {
  public:
    /// Throws usage_error for an unknown method or axis. `plan` must outlive it.
    explicit StressSchedule(const StressPlan& plan);

    const std::vector<StressSubject>& subjects() const { return subjects_; }
    const std::vector<StressAxis>& axes() const { return axes_; }
    const ArtifactStore& store() const { return store_; }
    Unstressed& unstressed() { return unstressed_; }
    SceneTools& tools() { return tools_; }
    std::size_t setting_count() const;

    /// The name of a setting: "tilt/89".
    static std::string key_of(const StressAxis& axis, const StressSetting& setting);
    StressWork work_of(const StressAxis& axis, const StressSetting& setting);

  private:
    const StressPlan& plan_;
    Registry registry_;
    std::vector<StressSubject> subjects_;
    std::vector<StressAxis> axes_;
    ArtifactStore store_;
    SceneTools tools_;
    Unstressed unstressed_;
};

}  // namespace aoscore
