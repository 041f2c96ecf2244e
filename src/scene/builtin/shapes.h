#pragma once

#include "scene/builtin/mesh_builder.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace aoscore::builtin {

/// Points of an outline or moulding, metres.
using Profile = std::vector<glm::dvec2>;

/// Appends `segments` + 1 points of a circular (elliptical) arc to a profile, skipping the first where it
/// repeats the profile's last point.
void append_arc(Profile& profile, const glm::dvec2& centre, const glm::dvec2& radii, double from_rad,
                double to_rad, int segments);

void add_box(MeshBuilder& mesh, const glm::dvec3& low, const glm::dvec3& high);

/// A box whose edges are cut at 45 degrees, `bevel_m` wide along each face.
void add_bevelled_box(MeshBuilder& mesh, const glm::dvec3& low, const glm::dvec3& high, double bevel_m);

/// Up to three crates stacked against a wall at z = 0, 0.84 m, 1.5 m and 2 m high.
void add_crates(MeshBuilder& mesh, int count);

/// A bevelled block that stands out of a surface: without its low z face, which belongs inside another solid.
void add_raised_block(MeshBuilder& mesh, const glm::dvec3& low, const glm::dvec3& high, double bevel_m);

/// Adds the patch f(u,v), u and v in [0,1], in columns x rows quads; its visible side is d/du x d/dv.
/// `wrap_u` closes it.
void add_surface(MeshBuilder& mesh, int columns, int rows, const std::function<glm::dvec3(double, double)>& f,
                 bool wrap_u = false);

/// A surface of revolution about the Y axis: (radius, y) points from bottom to top with the visible side
/// outwards.
void add_lathe(MeshBuilder& mesh, const Profile& radius_and_y, int segments);

/// Does add_lathe() between two angles about +y, 0 being +z; its two sides stay open.
void add_part_lathe(MeshBuilder& mesh, const Profile& radius_and_y, int segments, double from_rad,
                    double to_rad);

/// A moulding that runs around a rectangle in plan with mitred corners: a profile of (outward offset, y)
/// points, the rectangle being |x| <= half_x, |z| <= half_z at offset 0. Walking the profile upwards, the
/// visible side is outwards; downwards, inwards. A closed profile makes a closed solid.
void add_frame(MeshBuilder& mesh, const Profile& offset_and_y, double half_x, double half_z);

/// A straight moulding along z from z0 to z1 (z0 < z1), open at its ends. The (x,y) outline is walked
/// counter-clockwise about the solid, seen from +z.
void add_run(MeshBuilder& mesh, const Profile& outline, double z0, double z1);

/// Does add_run() for a closed outline that is star-shaped about its mean, and closes both ends.
void add_prism(MeshBuilder& mesh, const Profile& outline, double z0, double z1);

/// A ring of tube: centre line of radius `major_m` about the z axis, tube radius `minor_m`.
void add_torus(MeshBuilder& mesh, double major_m, double minor_m, int around, int across);

/// A sphere of almost equal triangles: the icosahedron, split `levels` times; vertices on the sphere.
void add_sphere(MeshBuilder& mesh, const glm::dvec3& centre, double radius_m, int levels);

}  // namespace aoscore::builtin
