// XeGTAO (Intel 2021): GTAO's slices spread evenly in the picture, falloff by blending a tap's cosine toward the tangent
// plane's, and a power over all.
#include "contract/ao_pass.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/slice.glsl"

float horizon_cosine(vec2 image_px, vec3 position, ViewSlice slice, float side, float open, float shift) {
    float radius = p_radius * p_radius_multiplier;
    vec2 reach_px = side * radius * slice.image_px;
    float radius_px = max(length(reach_px), 1e-6);
    float cosine = open;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float part = pow((float(j) + shift) / float(p_steps), p_step_power) + p_first_step_px / radius_px;
        vec2 offset_px = round(part * reach_px);
        float level = log2(max(length(offset_px), 1.0)) - p_mip_offset;
        int mip = int(clamp(level + 0.5, 0.0, float(kDepthMipLevels - 1)));
        vec3 v = tap_mip_position(image_px + offset_px, mip) - position;
        float distance_squared = dot(v, v);
        float weight = clamp((radius - sqrt(distance_squared)) / (p_falloff_range * radius), 0.0, 1.0);
        float tap = mix(open, dot(v, slice.view) * inversesqrt(distance_squared), weight);
        cosine = distance_squared > 0.0 ? max(cosine, tap) : cosine;
    }
    return cosine;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        float azimuth = (float(i) + noise.x) * (kPi / float(p_slices));
        ViewSlice slice = screen_slice(azimuth, position, normal, line_of_sight);
        float gamma = slice.normal_angle;
        float shift = fract(noise.y + float(i) * 0.61803399);
        float h0 = -acos(clamp(horizon_cosine(image_px, position, slice, -1.0, cos(gamma - kHalfPi), shift), -1.0, 1.0));
        float h1 = acos(clamp(horizon_cosine(image_px, position, slice, 1.0, cos(gamma + kHalfPi), shift), -1.0, 1.0));
        float length_in_slice = mix(slice.normal_length, 1.0, p_normal_lerp);
        sum += length_in_slice * (slice_arc(h0, gamma) + slice_arc(h1, gamma));
    }
    float open = limited_visibility(sum / float(p_slices));
    return max(p_least_visibility, pow(open, p_final_power));
}
