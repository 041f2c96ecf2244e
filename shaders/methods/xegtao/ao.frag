// XeGTAO (Intel 2021): GTAO's slices even in the picture, taps blended toward the tangent plane with their distance, and
// a power over all.
#include "contract/ao_pass.glsl"
#include "lib/hilbert.glsl"
#include "lib/noise.glsl"
#include "lib/quick_acos.glsl"
#include "lib/slice.glsl"

// Below this many pixels the published visibility is raised.
const float kSmallRadius_px = 10.0;

float arc_cosine(float x) { return p_acos == acos_exact ? acos(clamp(x, -1.0, 1.0)) : quick_acos(x); }

// The tap's point relative to `position`. `level` is a real number, the nearest mip counts.
vec3 tapped(vec2 image_px, float level, vec3 position) {
    int mip = int(clamp(level, 0.0, float(p_coarsest_mip)) + 0.5);
    if (p_outside == outside_of_run) return tap_mip_position(image_px, mip) - position;
    return view_position(floor(image_px) + 0.5, tap_mip_depth(inside_picture(image_px), mip)) - position;
}

float falloff_weight(vec3 v, float radius) {
    float thinned = length(vec3(v.xy, v.z * (1.0 + p_thin_occluder_compensation)));
    return clamp((radius - thinned) / (p_falloff_range * radius), 0.0, 1.0);
}

// Cosine of the horizon on one side, at least `open`, that of the tangent plane.
float horizon_cosine(vec2 image_px, vec3 position, ViewSlice slice, vec2 reach_px, float open, int index, float shift) {
    float radius = p_radius * p_radius_multiplier, radius_px = max(length(reach_px), 1e-6);
    float cosine = open;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        // The R1 sequence over slices and steps.
        float xi = fract(shift + float(index + j * p_steps) * 0.61803398875);
        float part = pow((float(j) + xi) / float(p_steps), p_step_power) + p_first_step_px / radius_px;
        vec2 offset_px = part * reach_px;
        vec3 v = tapped(image_px + round(offset_px), log2(length(offset_px)) - p_mip_offset, position);
        float distance_squared = dot(v, v);
        float tap = mix(open, dot(v, slice.view) * inversesqrt(distance_squared), falloff_weight(v, radius));
        cosine = distance_squared > 0.0 ? max(cosine, tap) : cosine;
    }
    return cosine;
}

float slice_visibility(int i, vec2 image_px, vec3 position, vec3 normal, vec3 line_of_sight, vec2 noise) {
    // Azimuths turn toward the upper edge of the picture.
    ViewSlice slice = screen_slice(-(float(i) + noise.x) * (kPi / float(p_slices)), position, normal, line_of_sight);
    float cosine = clamp(dot(normal, slice.view) / slice.normal_length, 0.0, 1.0);
    float gamma = slice.normal_angle < 0.0 ? -arc_cosine(cosine) : arc_cosine(cosine);
    vec2 reach_px = p_radius * p_radius_multiplier * slice.image_px;
    float h0 = -arc_cosine(horizon_cosine(image_px, position, slice, -reach_px, cos(gamma - kHalfPi), i, noise.y));
    float h1 = arc_cosine(horizon_cosine(image_px, position, slice, reach_px, cos(gamma + kHalfPi), i, noise.y));
    return mix(slice.normal_length, 1.0, p_normal_lerp) * (slice_arc(h0, gamma) + slice_arc(h1, gamma));
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric(), line_of_sight = view_ray(image_px);
    // A little toward the viewer, against rounding of the stored depth.
    position -= line_of_sight * (-position.z * p_toward_viewer);
    vec2 noise = p_noise == noise_hilbert_r2 ? hilbert_noise() : pixel_noise().xy;
    float radius_px = p_radius * p_radius_multiplier * pixels_per_metre(-position.z);
    float sum = 0.5 * clamp((kSmallRadius_px - radius_px) / 100.0, 0.0, 1.0);
    for (int i = 0; i < p_slices; ++i) sum += slice_visibility(i, image_px, position, normal, line_of_sight, noise);
    float open = sum < 0.0 ? 0.0 : sum / float(p_slices);
    open = pow(open, p_final_power);
    return open < p_least_visibility ? p_least_visibility : (open > p_most_visibility ? p_most_visibility : open);
}
