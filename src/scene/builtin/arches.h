#pragma once

#include "scene/builtin/shapes.h"

namespace aoscore::builtin {

/// The line of an arch's opening: from the right springing (half_width, 0) over the apex to the left one,
/// exactly symmetric, y up. Each half has `segments` segments.
Profile semicircular_arch(double half_width_m, double rise_m, int segments);

/// A Gothic arch: two circle arcs that meet in a point at (0, rise); rise > half_width.
Profile pointed_arch(double half_width_m, double rise_m, int segments);

/// A wall with an arched opening: |x| <= half_width, 0 <= y <= height, |z| <= half_thickness, without top and
/// without its two ends, so that walls of equal section join seamlessly into a row. The undersides beside the
/// opening are left out where the wall stands on something.
enum class Underside { closed, open };
void add_arched_wall(MeshBuilder& mesh, const Profile& arch, double half_width_m, double height_m,
                     double half_thickness_m, Underside underside = Underside::closed);

/// The same arch on vertical jambs: its springing moves up from y = 0 by `jamb_m`.
Profile stilted(const Profile& arch, double jamb_m);

/// The same arch, stretched to another width.
Profile widened(const Profile& arch, double half_width_m);

/// A wall with a window: |x| <= half_width, low <= y <= high, |z| <= half_thickness; the opening (an arch on
/// jambs) stands on its sill at y = sill. It has no top, underside or ends, like add_arched_wall().
struct WindowWall {
    double half_width_m, low_m, sill_m, high_m, half_thickness_m;
};
void add_window_wall(MeshBuilder& mesh, const Profile& opening, const WindowWall& wall);

/// A moulding along an arch. The closed section of (outward offset from the line, z) points is walked
/// counter-clockwise with the offset to the right and z up. Ends are open: they belong inside an impost.
void add_arch_moulding(MeshBuilder& mesh, const Profile& arch, const Profile& offset_and_z);

/// The vault of two crossing barrels, seen from below: their sections are `along_x` and `along_z`, arches of
/// equal rise and point count, whose widths are the bay's. y is 0 at the springing; `rows` divides a web from
/// groin to edge.
void add_groin_vault(MeshBuilder& mesh, const Profile& along_x, const Profile& along_z, int rows);

}  // namespace aoscore::builtin
