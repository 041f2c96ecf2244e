// Ground-truth ambient occlusion (Jimenez et al. 2016). The method says in tap_cosine() what a tap finds.
// V = mean over slices of |n_p| (a(h0) + a(h1)), a(h) = ¼ (cos γ + 2h sin γ - cos(2h - γ)), h clamped to γ ± π/2.
#include "contract/inputs.glsl"
#include "lib/noise.glsl"
#include "lib/open_slice.glsl"
#include "lib/slice.glsl"

float weight(float distance_squared) {
    if (p_falloff_range == 0.0) return distance_squared < p_radius * p_radius ? 1.0 : 0.0;
    return clamp((p_radius - sqrt(distance_squared)) / (p_falloff_range * p_radius), 0.0, 1.0);
}

// One side of a slice: +1 along it, -1 against it; `open` is the cosine of the tangent plane.
struct SideOfSlice {
    ViewSlice slice;
    vec3 position;
    float side, open;
};

// Nothing: a tap of the pixel itself, or one on the other side.
const float kNoTap = -2.0;

// The cosine from the view vector to what the tap at this place finds.
float tap_cosine(vec2 tap_px, SideOfSlice at);

float cosine_of(vec3 tap, SideOfSlice at) {
    vec3 v = into_slice(tap - at.position, at.slice);
    float distance_squared = dot(v, v);
    float cosine = mix(at.open, dot(v, at.slice.view) * inversesqrt(distance_squared), weight(distance_squared));
    return at.side * dot(v, at.slice.along) > 0.0 ? cosine : kNoTap;
}

// Cosine of the horizon.
float horizon_cosine(vec2 image_px, SideOfSlice at, float shift) {
    vec2 reach_px = at.side * p_radius * at.slice.image_px;
    float least = inversesqrt(max(dot(reach_px, reach_px), 1e-12));  // one pixel
    float cosine = at.open;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float part = max(pow((float(j) + shift) / float(p_steps), p_step_power), least);
        float tap = tap_cosine(image_px + part * reach_px, at);
        bool counts = tap != kNoTap && part <= 1.0;
        float fallen = mix(cosine, tap, p_thickness_blend);
        cosine = counts ? (tap > cosine ? tap : fallen) : cosine;
    }
    return max(cosine, at.open);
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

float slices_visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        ViewSlice slice = view_slice((float(i) + noise.x) * (kPi / float(p_slices)), position, normal, line_of_sight);
        float gamma = slice.normal_angle;
        SideOfSlice against = SideOfSlice(slice, position, -1.0, cos(gamma - kHalfPi));
        SideOfSlice along = SideOfSlice(slice, position, 1.0, cos(gamma + kHalfPi));
        float cosine0 = horizon_cosine(image_px, against, noise.y);
        float cosine1 = horizon_cosine(image_px, along, noise.y);
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
    return with_bounces(sum / float(p_slices));
}
