// XeGTAO's edge-aware mean of the 3x3 pixels around: neighbours count as far as no edge in depth lies between.
#include "contract/filter_pass.glsl"

// Of a pixel's four sides, how far each is free of an edge: x left, y right, z above, w below. Outside of the picture
// those of the nearest pixel.
vec4 open_sides(ivec2 texel) {
    texel = clamp(texel, ivec2(0), ivec2(u_size_px) - 1);
    float here = filter_depth(texel);
    vec4 step = vec4(filter_depth(texel + ivec2(-1, 0)), filter_depth(texel + ivec2(1, 0)),
                     filter_depth(texel + ivec2(0, -1)), filter_depth(texel + ivec2(0, 1))) - here;
    // A slope is no edge: the steps with the mean slope of both sides taken off may be smaller.
    vec2 slope = 0.5 * (step.yw - step.xz);
    vec4 level = min(abs(step), abs(step + vec4(slope.x, -slope.x, slope.y, -slope.y)));
    vec4 open = clamp(1.25 - level / (here * p_depth_threshold), 0.0, 1.0);
    return p_edge_bits == edge_bits_two ? round(open * 2.9) / 3.0 : open;
}

// A side is as open as both of its pixels find it; where hardly one is, some light leaks in.
vec4 mutual(vec4 here, vec4 left, vec4 right, vec4 above, vec4 below) {
    vec4 open = here * vec4(left.y, right.x, above.w, below.z);
    float leak = clamp(1.5 - dot(open, vec4(1.0)), 0.0, 1.0) / 1.5 * p_leak;
    return clamp(open + leak, 0.0, 1.0);
}

float filtered(ivec2 texel) {
    vec4 left = open_sides(texel + ivec2(-1, 0)), right = open_sides(texel + ivec2(1, 0));
    vec4 above = open_sides(texel + ivec2(0, -1)), below = open_sides(texel + ivec2(0, 1));
    vec4 open = mutual(open_sides(texel), left, right, above, below);

    float sum = p_centre_weight * tap_visibility(texel);
    sum += open.x * tap_visibility(texel + ivec2(-1, 0)) + open.y * tap_visibility(texel + ivec2(1, 0));
    sum += open.z * tap_visibility(texel + ivec2(0, -1)) + open.w * tap_visibility(texel + ivec2(0, 1));
    // To a corner there are two ways around.
    vec4 corners = p_diagonal_weight * 0.5 *
                   vec4(open.x * left.z + open.z * above.x, open.z * above.y + open.y * right.z,
                        open.w * below.x + open.x * left.w, open.y * right.w + open.w * below.y);
    sum += corners.x * tap_visibility(texel + ivec2(-1, -1)) + corners.y * tap_visibility(texel + ivec2(1, -1));
    sum += corners.z * tap_visibility(texel + ivec2(-1, 1)) + corners.w * tap_visibility(texel + ivec2(1, 1));
    float mean = sum / (p_centre_weight + dot(open + corners, vec4(1.0)));
    return mean > 1.0 ? 1.0 : mean;
}
