#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace aoscore::testing {

/// An empty scene with one solid material.
Scene empty_scene();
/// Adds a mesh and places it once.
void add(Scene& scene, Mesh mesh);
/// A mesh of two triangles.
Mesh quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);
/// A square of side 2 h in y = 0 about the origin, cut into n x n cells.
Mesh floor_grid(double half_size, int cells);
/// A sphere of n x 2n facets, corners on the sphere.
Mesh sphere(const glm::dvec3& centre, double radius, int n);

/// A floor with a few spheres and a screen on it, and sky behind: edges, contact and open space in one
/// picture.
Scene still_life();
/// Three hundred thin blades at random over a floor.
Scene thicket();

/// The same scene and camera moved together by a similarity: rotation, then scale, then translation.
struct Similarity {
    double scale = 1;
    glm::dvec3 axis{0, 1, 0};
    double angle_rad = 0;
    glm::dvec3 translation{0};
    glm::dmat4 matrix() const;
};
Scene moved(Scene scene, const Similarity& by);
Camera moved(Camera camera, const Similarity& by);

/// A camera over the floor that looks at `target` from `position`.
Camera looking(const glm::dvec3& position, const glm::dvec3& target, double fovy_rad = 0.6);

}  // namespace aoscore::testing
