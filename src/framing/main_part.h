#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// The part of a scene that a picture should show: all of it but parts that lie far off, such as a forgotten
/// triangle or an endless ground plane.
struct MainPart {
    Bounds bounds;                    ///< bounds of its triangles
    std::vector<glm::dvec3> outline;  ///< its outermost vertices, at least one
};

/// Takes the triangles within the outer fences of the scene's vertices on each axis: these lie three times
/// the distance between the quartiles beyond them, by the largest such distance of the three axes (Tukey,
/// Exploratory Data Analysis, 1977, "far out"). A vertex weighs as much as the edges of its triangle are
/// long, so that neither a dense mesh nor a large plane decides alone. Where that leaves less than half of
/// the edges, it takes all triangles. Neither the unit of length nor what lies outside of the fences changes
/// the answer.
MainPart main_part(const Scene& scene);

}  // namespace aoscore
