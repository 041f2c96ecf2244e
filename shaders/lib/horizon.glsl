// Marching over the depth surface in image directions.
#include "contract/view.glsl"
#include "lib/constants.glsl"

// The i-th of `count` evenly spread image directions, turned by `turn` in [0,1) of their spacing.
vec2 image_direction(int i, int count, float turn) {
    float angle = (float(i) + turn) * (kTwoPi / float(count));
    return vec2(cos(angle), sin(angle));
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
