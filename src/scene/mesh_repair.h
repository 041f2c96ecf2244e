#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace aoscore {

/// Removes triangles without area. Returns how many there were.
std::size_t drop_degenerate_triangles(Mesh& mesh);

/// Makes a mesh's vertex normals unit. Those that are zero or not finite become the mean of the adjacent
/// faces' normals, weighted by area; when all are, the mesh loses its normals and is flat. Returns their
/// number.
std::size_t repair_normals(Mesh& mesh);

}  // namespace aoscore
