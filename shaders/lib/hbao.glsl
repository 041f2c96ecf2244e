// Horizon-based ambient occlusion (Bavoil, Sainz and Dimitrov 2008; Vermeer 2020, algorithm 2).
// O = 1/N_d sum over directions of sum over samples that raise the horizon: W(|v|) (sin phi - sin h), W = 1 - (d/R)²,
// h beginning at the tangent's angle t + bias. All angles are to the picture plane and lie in [-π/2, π/2], where the
// sine is monotone: sines are compared instead. The method says in best_rise() what a step of the march finds.
#include "contract/inputs.glsl"
#include "lib/horizon.glsl"
#include "lib/noise.glsl"
#include "lib/open_horizon.glsl"
#include "lib/shading_normal.glsl"

// From where a step looks, and over what.
struct March {
    vec3 position, normal;
    Slice slice;
    float sin_horizon;
};

// What a surface adds, and the horizon's sine after it.
struct Rise {
    float occlusion;  // negative where it does not rise over the horizon
    float sin_horizon;
};
Rise no_rise(March march) { return Rise(-1.0, march.sin_horizon); }

// What the step adds that reads the surface at this place.
Rise best_rise(vec2 tap_px, March march);

float attenuation(float distance_squared) {
    return p_falloff == falloff_none ? 1.0 : 1.0 - distance_squared / (p_radius * p_radius);
}

bool within_threshold(float cosine) { return p_threshold > 3.1415 || cosine >= cos(p_threshold); }

// The direction in the tangent plane that the picture's direction and the view's axis span, as algorithm 2 has it.
vec3 printed_tangent(vec2 direction, vec3 normal) {
    vec3 along = view_of_image_direction(direction);
    return along - vec3(0.0, 0.0, dot(along, normal) / max(normal.z, 1e-4));
}

// From the pixel to a tap, where the march has it.
vec3 marched(vec3 tap, March march) {
    vec3 v = tap - march.position;
    return p_plane == plane_picture ? v : into_slice(v, march.slice);
}

float sine_of_elevation(vec3 v) { return v.z * inversesqrt(dot(v, v)); }

Rise rise_of(vec3 tap, March march) {
    vec3 v = marched(tap, march);
    float distance_squared = dot(v, v);
    float inverse_distance = inversesqrt(distance_squared);
    float sin_elevation = v.z * inverse_distance;
    // A tap of the pixel itself has no direction; its comparisons are all false.
    bool rises = distance_squared > 0.0 && distance_squared < p_radius * p_radius &&
                 sin_elevation > march.sin_horizon && within_threshold(dot(v, march.normal) * inverse_distance);
    float occlusion = attenuation(distance_squared) * (sin_elevation - march.sin_horizon);
    return Rise(rises ? occlusion : no_rise(march).occlusion, rises ? sin_elevation : march.sin_horizon);
}

// The mean over directions.
float horizon_occlusion(vec2 image_px, vec3 position) {
    vec3 normal = shading_normal();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    float step_px = p_radius * pixels_per_metre(-position.z) / float(p_steps + 1);

    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        Slice slice = slice_along(direction, normal, line_of_sight);
        vec3 tangent = p_plane == plane_picture ? printed_tangent(direction, normal) : slice.tangent;
        float tangent_angle = min(elevation(tangent) + p_bias, kHalfPi);
        March march = March(position, normal, slice, sin(tangent_angle));
#pragma unroll
        for (int j = 0; j < p_steps; ++j) {
            Rise rise = best_rise(image_px + direction * (float(j + 1) + noise.y) * step_px, march);
            occlusion += max(rise.occlusion, 0.0);
            march.sin_horizon = rise.sin_horizon;
        }
#ifdef OPEN_CONE
        add_horizon(direction, normal, max(asin(clamp(march.sin_horizon, -1.0, 1.0)) - tangent_angle, 0.0));
#endif
    }
#ifdef OPEN_CONE
    write_horizons(p_directions);
#endif
    return occlusion / float(p_directions);
}
