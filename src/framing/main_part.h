#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// What a picture of a scene should show: all of it but parts that lie far off, such as a forgotten triangle
/// or a ground plane that goes on for ever.
struct MainPart {
    Bounds bounds;                    ///< of its triangles
    std::vector<glm::dvec3> outline;  ///< those of its vertices that lie outermost, at least one
};

/// The triangles within the outer fences of the scene's vertices, axis by axis: three times the distance of
/// the quartiles beyond them, the largest such distance of the three axes (Tukey, Exploratory Data Analysis,
/// 1977, "far out"). A vertex weighs as much as the edges of its triangle are long, so that neither a dense
/// mesh nor a large plane decides alone. Where that leaves less than half of the edges, all triangles.
/// Neither the unit of length nor what lies outside of the fences changes the answer.
MainPart main_part(const Scene& scene);

}  // namespace aoscore
