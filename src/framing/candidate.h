#pragma once

#include "framing/main_part.h"
#include "reference/tracer/scout.h"
#include "scene/scene.h"

#include <vector>

namespace aoscore {

/// A camera that might become a view, and how good its picture is.
struct Candidate {
    Camera camera;
    double worth = 0;  ///< of its picture, 0 and up
    Glance glance;     ///< what it sees
};

/// How pictures are tried.
struct Trial {
    const Scout& scout;
    const MainPart& main;
    double radius_m = 0;  ///< of the occlusion that is looked for
    double aspect = 1;    ///< width to height
    Bounds bounds;        ///< of the whole scene
};

/// Looks through every camera, on all threads: sets glance, worth, and near and far of the cameras.
///
/// A picture is worth the more, the more its visibility varies (standard deviation), the more of it is
/// covered, the more of what it shows belongs to the main part and is seen from the front, and the fewer of
/// its pixels show what is close to the camera (nearer than `close_m`).
void try_cameras(const Trial& trial, double close_m, std::vector<Candidate>& candidates);

/// The one of most worth; of several within what rounding could swap, the first. `candidates` has some.
const Candidate& best_of(const std::vector<Candidate>& candidates);

}  // namespace aoscore
