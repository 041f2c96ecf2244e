// Marching over the depth surface in image directions.
#include "contract/mirror.glsl"
#include "contract/view.glsl"
#include "lib/constants.glsl"

// The i-th of `count` evenly spread image directions, turned by `turn` in [0,1) of their spacing.
vec2 image_direction(int i, int count, float turn) {
    float angle = (float(i) + turn) * (kTwoPi / float(count));
    return mirrored(vec2(cos(angle), sin(angle)));
}

// The view-space direction along the picture plane; image y runs down.
vec3 view_of_image_direction(vec2 direction) { return vec3(direction.x, -direction.y, 0.0); }

// The direction in the tangent plane that a march in this image direction follows: the slice that it sees contains
// the line of sight, so that every point of a plane lies exactly on its tangent, in perspective too. Not unit.
vec3 slice_tangent(vec2 direction, vec3 normal, vec3 line_of_sight) {
    vec3 along = view_of_image_direction(direction);
    float facing = min(dot(line_of_sight, normal), -1e-4);
    return along - line_of_sight * (dot(along, normal) / facing);
}

// A tap is read at its texel's centre, up to half a texel beside the slice. It is moved into the slice along the
// tangent plane: it keeps its height over that plane, and a tap of the plane itself its elevation.
struct Slice {
    vec3 tangent;  // not unit
    vec3 across;   // in the tangent plane, where the picture's perpendicular direction leads
    vec3 measure;  // v · measure: how many `across` v lies beside the slice
};

Slice slice_along(vec2 direction, vec3 normal, vec3 line_of_sight) {
    vec3 across = slice_tangent(vec2(-direction.y, direction.x), normal, line_of_sight);
    vec3 slice_normal = cross(line_of_sight, view_of_image_direction(direction));
    return Slice(slice_tangent(direction, normal, line_of_sight), across, slice_normal / dot(across, slice_normal));
}

vec3 into_slice(vec3 v, Slice slice) { return v - slice.across * dot(v, slice.measure); }

// Angle to the picture plane, positive toward the viewer.
float elevation(vec3 v) { return asin(clamp(v.z * inversesqrt(dot(v, v)), -1.0, 1.0)); }
