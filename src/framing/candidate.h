#pragma once

#include "framing/main_part.h"
#include "reference/tracer/scout.h"
#include "scene/scene.h"

#include <vector>

namespace aoscore {

/// A camera that might become a view, with the worth of its picture.
struct Candidate {
    Camera camera;
    double worth = 0;  ///< worth of its picture, 0 or more
    Glance glance;     ///< the picture that it sees
};

/// Parameters for trying pictures.
struct Trial {
    const Scout& scout;
    const MainPart& main;
    double radius_m = 0;  ///< AO radius
    double aspect = 1;    ///< width to height
    Bounds bounds;        ///< bounds of the whole scene
};

/// Traces a small picture from every camera, on all threads, and sets glance, worth, and the camera's near
/// and far.
///
/// A picture is worth more when its visibility varies more (standard deviation), when more of it is covered,
/// when more of the surfaces in it belong to the main part and face the camera, and when fewer of its pixels
/// are nearer to the camera than `close_m`.
void try_cameras(const Trial& trial, double close_m, std::vector<Candidate>& candidates);

/// The candidate of most worth; the first where rounding could swap several. `candidates` must not be empty.
const Candidate& best_of(const std::vector<Candidate>& candidates);

}  // namespace aoscore
