// Ground-truth ambient occlusion (Jimenez et al. 2016).
// V = mean over slices of |n_p| (a(h0) + a(h1)), a(h) = ¼ (cos γ + 2h sin γ - cos(2h - γ)), h clamped to γ ± π/2.
#include "contract/ao_pass.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/open_slice.glsl"
#include "lib/slice.glsl"

float weight(float distance_squared) {
    if (p_falloff_range == 0.0) return distance_squared < p_radius * p_radius ? 1.0 : 0.0;
    return clamp((p_radius - sqrt(distance_squared)) / (p_falloff_range * p_radius), 0.0, 1.0);
}

// Cosine of the horizon on one side; `open` is that of the tangent plane.
float horizon_cosine(vec2 image_px, vec3 position, ViewSlice slice, float side, float open, float shift) {
    vec2 reach_px = side * p_radius * slice.image_px;
    float least = inversesqrt(max(dot(reach_px, reach_px), 1e-12));  // one pixel
    float cosine = open;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float part = max(pow((float(j) + shift) / float(p_steps), p_step_power), least);
        vec3 v = into_slice(tap_position(image_px + part * reach_px) - position, slice);
        float distance_squared = dot(v, v);
        float tap = mix(open, dot(v, slice.view) * inversesqrt(distance_squared), weight(distance_squared));
        bool counts = side * dot(v, slice.along) > 0.0 && part <= 1.0;  // not the pixel itself
        float fallen = mix(cosine, tap, p_thickness_blend);
        cosine = counts ? (tap > cosine ? tap : fallen) : cosine;
    }
    return max(cosine, open);
}

// Multi-bounce visibility for a grey albedo: a cubic fit.
float with_bounces(float v) {
    float a = 2.0404 * p_bounce_albedo - 0.3324;
    float b = -4.7951 * p_bounce_albedo + 0.6417;
    float c = 2.7552 * p_bounce_albedo + 0.6903;
    return p_bounce_albedo > 0.0 ? max(v, ((v * a + b) * v + c) * v) : v;
}

#ifdef OPEN_CONE
void add_open_part(float h0, float h1, ViewSlice slice) {
    float gamma = slice.normal_angle;
    if (p_bent_weights == bent_weights_uniform) {
        add_open_arc(uniform_arc(h1) - uniform_arc(h0), slice);
    } else {
        add_open_arc(slice.normal_length * (cosine_arc(h1, gamma) - cosine_arc(h0, gamma)), slice);
    }
}

// The published cone is that of the visibility alone: cos α = sqrt(1 - V).
void write_open_part(float open, vec3 normal) {
    if (p_bent_weights == bent_weights_uniform) {
        write_mean_direction(open_sum, open_weight, normal);
    } else {
        write_open_cone(open_weight > 0.0 ? open_sum / open_weight : normal, acos(sqrt(1.0 - clamp(open, 0.0, 1.0))));
    }
}
#endif

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        ViewSlice slice = view_slice((float(i) + noise.x) * (kPi / float(p_slices)), position, normal, line_of_sight);
        float gamma = slice.normal_angle;
        float cosine0 = horizon_cosine(image_px, position, slice, -1.0, cos(gamma - kHalfPi), noise.y);
        float cosine1 = horizon_cosine(image_px, position, slice, 1.0, cos(gamma + kHalfPi), noise.y);
        float h0 = max(-acos(clamp(cosine0, -1.0, 1.0)), gamma - kHalfPi);
        float h1 = min(acos(clamp(cosine1, -1.0, 1.0)), gamma + kHalfPi);
        sum += slice.normal_length * (slice_arc(h0, gamma) + slice_arc(h1, gamma));
#ifdef OPEN_CONE
        add_open_part(h0, h1, slice);
#endif
    }
#ifdef OPEN_CONE
    write_open_part(sum / float(p_slices), normal);
#endif
    return limited_visibility(with_bounces(sum / float(p_slices)));
}
