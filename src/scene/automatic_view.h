#pragma once

#include "scene/scene.h"

namespace aoscore {

/// The view of a scene that has none of its own, "auto"; +y is up, the picture 60 degrees high:
///
/// - A scene whose middle is in a room (of rays from the centre of the bounds all around, at least 7 in 10
/// meet the
///   front of a surface first) is looked at from inside: of some places along the two horizontal axes, at a
///   third of the height, the one that sees furthest along its axis, by the median distance of a cone of
///   rays.
/// - Any other one is looked at from outside, from (0.8, 0.5, 1) as seen from the centre, so far away that a
/// sphere
///   around the bounds fills the picture.
///
/// Deterministic. The time is bounded whatever the scene: rays are fewer where triangles are more.
View automatic_view(const Scene& scene);

}  // namespace aoscore
