#pragma once

#include "plan/run_modes.h"
#include "scene/scene.h"

namespace aoscore {

/// Everything that one setting of a stress axis may change of what methods are run on.
struct StressCase {
    Scene scene;
    Camera camera;
    int width = 256, height = 256;
    RunModes modes;
    /// The scene's size over that of the base: parameters that are lengths, areas, … are scaled along, as
    /// their descriptors say.
    double length_scale = 1;
    double radius_scale = 1;  ///< of the methods' radius alone
    /// Too large to be traced: only the mean visibility can be held against the base.
    bool has_truth = true;
    bool performance_presets_only = false;
};

/// The case that nothing is done to: the scene `yard` from its first view, `size` pixels square.
StressCase base_stress_case(int size);

/// Measures what was done to the scene and moves its origin as the loader does. Throws file_error for a scene
/// that no picture can be made of.
void finish_stress_case(StressCase& stress);

}  // namespace aoscore
