#pragma once

#include "screen/screen.h"
#include "store/key.h"
#include "stress/stress.h"
#include "stress/stress_axes.h"
#include "stress/stress_subjects.h"

#include <string>
#include <vector>

namespace aoscore {

/// Digests of everything that a setting's results depend on: the code, the renderer and the machine that make
/// and time them, the shaders, the subjects, the plan's effort, and the case with its scene, camera and
/// modes.
class StressKeys {
  public:
    StressKeys(const StressPlan& plan, const std::vector<StressSubject>& subjects,
               const ScreenRenderer& renderer);
    std::string of(const StressAxis& axis, const StressSetting& setting, const StressCase& stress) const;

  private:
    Key common_;
};

}  // namespace aoscore
