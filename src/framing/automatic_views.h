#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace aoscore {

/// Two or three views of a scene that has none, for pictures of this width to height; +y is up.
///
/// - A scene with rooms (see survey_rooms()) is shown from three seats in them: "auto_inside",
///   "auto_inside_2", "auto_inside_3"; or, where a picture from outside shows as much, such as through the
///   open side of a box, from there, and from up to two seats that show as much.
/// - Any other scene is shown from two sides outside, fitted to the outline of its main part: "auto_outside",
///   "auto_outside_2".
///
/// All of them are ranked at one radius: 2 % of the diagonal of the main part, but at most a tenth of the
/// least of their median depths. The views are deterministic, and the same in any unit of length up to
/// rounding. The cost is that of building the scene for tracing and about a million rays.
std::vector<View> automatic_views(const Scene& scene, double aspect);

/// The AO radius where nothing else decides: this share of the diagonal of the main part (see main_part()).
constexpr double kRadiusPerDiagonal = 0.02;
std::string main_part_radius_rule();

/// Says in words how the radius of an automatic view was found; empty for any other view.
std::string automatic_radius_rule(const View& view);

/// Makes an automatic view, without its radius and note.
View automatic_view_of(const std::string& id, const Camera& camera);

}  // namespace aoscore
