#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace aoscore {

/// Two or three views of a scene that has none, for pictures of this width to height; +y is up.
///
/// - A scene with rooms (see survey_rooms()) is looked at from three seats in them: "auto_inside",
///   "auto_inside_2", "auto_inside_3"; or, where a look into it from outside shows as much, such as
///   through the open side of a box, from there, and from up to two
///   seats that show as much.
/// - Any other one from two sides outside, fitted to the outline of its main part: "auto_outside",
///   "auto_outside_2".
///
/// All of them are ranked at one radius: 2 % of the diagonal of the main part, but at most a tenth of the
/// distance of what the nearest of them shows in the median. Deterministic, and the same in any unit of
/// length up to rounding. Costs the building of the scene for tracing and about a million rays.
std::vector<View> automatic_views(const Scene& scene, double aspect);

/// The AO radius where nothing else decides: this share of the diagonal of the main part (see main_part()).
constexpr double kRadiusPerDiagonal = 0.02;
std::string main_part_radius_rule();

/// In words, how the radius of an automatic view was found; empty for any other view.
std::string automatic_radius_rule(const View& view);

/// A view of that kind, all but its radius and note.
View automatic_view_of(const std::string& id, const Camera& camera);

}  // namespace aoscore
