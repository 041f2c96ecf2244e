#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace aoscore::importer {

/// The triangles of a simple polygon in space, convex or not, as indices of its corners: n - 2 of them in the
/// polygon's own winding. Corners need not lie in one plane exactly; the polygon is looked at along the
/// normal of Newell's method. Ears are cut off (Meisters, "Polygons have ears", 1975). A polygon that crosses
/// itself is covered somehow. Corners in a row along one line make triangles without area.
std::vector<glm::uvec3> triangulate(std::span<const glm::dvec3> corners);

}  // namespace aoscore::importer
