#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace aoscore {

/// Two or three views of a scene that has none, for pictures of this width to height; +y is up.
///
/// - A scene that is mostly rooms (see survey_rooms()) is looked at from up to three seats in them:
/// "auto_inside",
///   "auto_inside_2", "auto_inside_3".
/// - One that is partly rooms, or hollow, from outside and from two seats.
/// - Any other one from two sides outside, fitted to the outline of its main part: "auto_outside",
/// "auto_outside_2".
///
/// All of them are ranked at one radius: 2 % of the diagonal of the main part, but at most a tenth of the
/// distance of what the nearest of them shows in the median. Deterministic, and the same in any unit of
/// length up to rounding. Costs the building of the scene for tracing and about a million rays.
std::vector<View> automatic_views(const Scene& scene, double aspect);

/// A view of that kind, all but its radius and note.
View automatic_view_of(const std::string& id, const Camera& camera);

}  // namespace aoscore
