// Horizon-based ambient occlusion (Bavoil, Sainz and Dimitrov 2008; Vermeer 2020, algorithm 2).
// O = 1/N_d sum over directions of sum over samples that raise the horizon: W(|v|) (sin phi - sin h), W = 1 - (d/R)²,
// h beginning at the tangent's angle t + bias. All angles are to the picture plane and lie in [-π/2, π/2], where the
// sine is monotone: sines are compared instead.
#include "contract/ao_pass.glsl"
#include "lib/horizon.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/open_horizon.glsl"

float attenuation(float distance_squared) {
    return p_falloff == falloff_none ? 1.0 : 1.0 - distance_squared / (p_radius * p_radius);
}

#include "nvidia.glsl"

bool within_threshold(float cosine) { return p_threshold > 3.1415 || cosine >= cos(p_threshold); }

// The direction in the tangent plane that the picture's direction and the view's axis span, as algorithm 2 has it.
vec3 printed_tangent(vec2 direction, vec3 normal) {
    vec3 along = view_of_image_direction(direction);
    return along - vec3(0.0, 0.0, dot(along, normal) / max(normal.z, 1e-4));
}

float visibility(vec2 image_px, vec3 position) {
    if (p_form == form_nvidia) return nvidia_visibility(image_px, position);
    vec3 normal = p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    float step_px = p_radius * pixels_per_metre(-position.z) / float(p_steps + 1);

    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        Slice slice = slice_along(direction, normal, line_of_sight);
        vec3 tangent = p_plane == plane_picture ? printed_tangent(direction, normal) : slice.tangent;
        float tangent_angle = min(elevation(tangent) + p_bias, kHalfPi);
        float sin_horizon = sin(tangent_angle);
#pragma unroll
        for (int j = 0; j < p_steps; ++j) {
            vec3 tap = tap_position(image_px + direction * (float(j + 1) + noise.y) * step_px);
            vec3 v = p_plane == plane_picture ? tap - position : into_slice(tap - position, slice);
            float distance_squared = dot(v, v);
            float inverse_distance = inversesqrt(distance_squared);
            float sin_elevation = v.z * inverse_distance;
            // A tap of the pixel itself has no direction; its comparisons are all false.
            bool rises = distance_squared > 0.0 && distance_squared < p_radius * p_radius &&
                         sin_elevation > sin_horizon && within_threshold(dot(v, normal) * inverse_distance);
            occlusion += rises ? attenuation(distance_squared) * (sin_elevation - sin_horizon) : 0.0;
            sin_horizon = rises ? sin_elevation : sin_horizon;
        }
#ifdef OPEN_CONE
        add_horizon(direction, normal, max(asin(clamp(sin_horizon, -1.0, 1.0)) - tangent_angle, 0.0));
#endif
    }
#ifdef OPEN_CONE
    write_horizons(p_directions);
#endif
    return limited_visibility(1.0 - occlusion / float(p_directions));
}
