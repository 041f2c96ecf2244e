#pragma once

#include "plan/run_modes.h"
#include "scene/scene.h"

namespace aoscore {

/// The inputs of methods that a setting of a stress axis may change.
struct StressCase {
    Scene scene;
    Camera camera;
    int width = 256, height = 256;
    RunModes modes;
    /// The scene's size over that of the base. Parameters that are lengths, areas, … are scaled with it.
    double length_scale = 1;
    double radius_scale = 1;  ///< factor on the methods' radius alone
    /// False where the picture is too large to be traced: only the mean visibility is then compared.
    bool has_truth = true;
    bool performance_presets_only = false;
};

/// The unstressed case: the scene `yard` from its first view, `size` pixels square.
StressCase base_stress_case(int size);

/// Measures the changed scene and moves its origin as the loader does. Throws file_error for a scene that no
/// picture can be made of.
void finish_stress_case(StressCase& stress);

}  // namespace aoscore
