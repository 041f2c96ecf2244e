#pragma once

#include <embree3/rtcore.h>

#include <vector>

namespace aoscore {

/// A triangle that a ray meets.
struct MetTriangle {
    unsigned placement;  ///< the id of its geometry in the scene, or of its instance
    unsigned triangle;   ///< its number in the mesh
    float distance;      ///< in lengths of the ray's direction
    float u, v;          ///< barycentric, of the second and third corner
};

/// The first triangle that a ray meets, and all that it meets so little farther away that rounding may have
/// put them in the wrong order. Embree by itself returns one of them, and which one depends on how the scene
/// is laid out in trees; this set does not. In no order, maybe with repetitions; empty where there is none.
/// The scene must have been made by new_trace_scene().
std::vector<MetTriangle> first_triangles(RTCScene scene, const RTCRay& ray);

}  // namespace aoscore
