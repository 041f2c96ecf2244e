#pragma once

#include "scene/scene.h"

#include <string>

namespace aoscore {

/// Fills bounds (exact: over all vertices that triangles use) and triangle_count. Throws file_error at
/// `where` for a scene that no picture can be made of: transforms that overflow, bounds wider than 1e9 m
/// (squared lengths of such vectors leave float32), or more than 64 million triangles. A scene smaller than
/// 1e-6 m gets a warning.
void measure_scene(Scene& scene, const std::string& where);

/// The origin with which float32 keeps a scene's details: zero, or near the bounds' centre when that is
/// further away than 1000 diagonals, or than 1e4 m and one diagonal. `bounds` are in world coordinates. The
/// result is a multiple of a power of two near the diagonal, hence exactly representable.
glm::dvec3 suitable_origin(const Bounds& bounds);

/// Makes all coordinates of the scene relative to `origin` (world coordinates).
void move_origin(Scene& scene, const glm::dvec3& origin);

}  // namespace aoscore
