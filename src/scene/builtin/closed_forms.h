#pragma once

#include <glm/glm.hpp>

#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

/// The built-in scenes whose visibility is known in closed form: their dimensions (metres, Y up) and the
/// formulas. Visibility is cosine-weighted, 1 = open; a radius limits the length of occlusion rays (infinite:
/// no limit).
namespace aoscore::closed_form {

inline constexpr double kNoCutoff = std::numeric_limits<double>::infinity();

/// `plane`: a square through the origin, nothing else. V = 1.
namespace plane {
inline constexpr double kHalfSize_m = 40;
/// Unit normal: off every axis, so that no wrong sign or swapped axis goes unseen.
glm::dvec3 normal();
}  // namespace plane

/// `wall` and `wall_tall`: the floor is y = 0, the wall's face x = 0 looks along +x and runs along z.
namespace wall {
inline constexpr double kHeight_m = 1;
inline constexpr double kTallHeight_m = 8;
/// From z = 0 to either end. The finite length raises V of a floor point by at most d h^2 / (3 pi l^3), l the
/// distance along z to the nearer end: less than 3e-5 where expected_visibility() answers.
inline constexpr double kHalfLength_m = 150;
inline constexpr double kThickness_m = 1;
inline constexpr double kFloorHalfSize_m = 160;
}  // namespace wall

/// `sphere`: the floor is y = 0, the sphere floats above the origin, wholly above the floor.
namespace sphere {
inline constexpr double kRadius_m = 0.5;
inline constexpr double kCentreHeight_m = 0.8;
/// Icosahedron subdivisions. Corners lie on the sphere, flat faces inside: V is too high by up to 1e-4.
inline constexpr int kLevels = 6;
inline constexpr double kFloorHalfSize_m = 60;
}  // namespace sphere

/// `pit`: a vertical cylinder sunk into a large flat ground; the bottom is y = 0, its centre the origin.
namespace pit {
inline constexpr double kRadius_m = 1;
/// Zenith angle of the rim seen from the bottom's centre. It is not 45 degrees, so that sine and cosine
/// differ.
inline constexpr double kRimZenith_rad = 40.0 * std::numbers::pi / 180.0;
inline constexpr int kSegments = 256;  ///< the polygon has the circle's area
inline constexpr double kGroundRadius_m = 30;
double depth_m();
}  // namespace pit

/// Visibility of a floor point at `distance_m` > 0 from an infinitely long wall of height `height_m`: (1 + d
/// / sqrt(d^2 + h^2)) / 2, by the configuration factor of an infinite strip (Howell, A Catalog of Radiation
/// Heat Transfer Configuration Factors).
double wall_visibility(double distance_m, double height_m);

/// Visibility of a floor point at `distance_m` >= 0 from an endless wall for rays no longer than `radius_m`:
/// 1 - (acos c - c sqrt(1 - c^2)) / pi with c = d / R, and 1 for c >= 1. It follows from projecting the
/// blocked part of the unit hemisphere, a cap of half-angle acos c, onto the floor (Nusselt's analogue).
double wall_visibility_cutoff(double distance_m, double radius_m);

/// Visibility of a point at `distance_m` from the centre of a sphere of `sphere_radius_m` that lies wholly
/// above the horizon, the centre at `angle_rad` from the normal: 1 - (r/D)^2 cos(theta). With a cut-off only
/// the cone of directions that meet the sphere within `radius_m` counts.
double sphere_visibility(double distance_m, double angle_rad, double sphere_radius_m,
                         double radius_m = kNoCutoff);

/// Visibility of the centre of a circular pit's bottom, its rim at zenith angle `rim_zenith_rad`: sin^2 h.
double pit_visibility(double rim_zenith_rad);

/// Visibility of a point of the bottom, `offset_m` from its centre: the configuration factor of the pit's
/// opening seen by a parallel plane element (Hamilton and Morgan, Radiant-Interchange Configuration Factors,
/// 1952). Equals pit_visibility() at the centre.
double pit_visibility_at(double offset_m, double pit_radius_m, double pit_depth_m);

/// The exact visibility at a scene point of built-in scene `scene_id` with this ray length, where one is
/// known. Returns nothing for other scenes, for points off the surface the formula is for (plane, floor, pit
/// bottom; 1 mm), nearer than 1 cm to a wall's foot, farther than 10 m from the origin, and for cut-offs that
/// no formula covers.
std::optional<double> expected_visibility(std::string_view scene_id, const glm::dvec3& point,
                                          double radius_m);

}  // namespace aoscore::closed_form
