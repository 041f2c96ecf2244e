// HBAO+: O = 1/(N_d N_s) sum of W(|v|) max(n·v/|v| - bias, 0), W = max(1 - (d/R)², 0); with taps as Vermeer (2020,
// algorithm 3) spreads them, or as NVIDIA's implementation does.
#include "contract/ao_pass.glsl"
#include "lib/horizon.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/open_horizon.glsl"

// NVIDIA draws the picture as 4x4 smaller ones of every fourth pixel, so that a pixel's taps stay within its own.
const float kInterleaved = 4.0;

float tap_distance_px(int j, float shift, float radius_px) {
    float step_px = radius_px / float(p_steps + 1);
    return p_interleaved ? kInterleaved + (float(j) + shift) * step_px : (float(j + 1) + shift) * step_px;
}

// Into the smaller picture, at its edge where it ends.
vec2 own_texel(vec2 tap_px, vec2 image_px) {
    vec2 first = mod(floor(image_px), kInterleaved) + 0.5;
    return clamp(tap_px, first, first + kInterleaved * floor((u_size_px - first) / kInterleaved));
}

vec3 tapped(vec2 image_px, vec2 offset_px) {
    if (!p_interleaved) return tap_position(image_px + offset_px);
    vec2 tap_px = image_px + kInterleaved * round(offset_px / kInterleaved);
    return view_position(tap_px, tap_linear_depth(own_texel(tap_px, image_px)));
}

float direction_occlusion(vec2 direction, vec2 image_px, vec3 position, vec3 normal, float shift) {
    float radius_px = p_radius * pixels_per_metre(-position.z);
    float sum = 0.0;
#ifdef OPEN_CONE
    float highest = 0.0;  // cosine to the normal over the bias, of taps within the radius
#endif
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        vec3 v = tapped(image_px, direction * tap_distance_px(j, shift, radius_px)) - position;
        float distance_squared = dot(v, v);
        float attenuation = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
        float cosine = dot(v, normal) * inversesqrt(distance_squared);
        float weight = j == 0 ? p_first_weight : 1.0;
        sum += distance_squared > 0.0 ? weight * attenuation * max(cosine - p_bias, 0.0) : 0.0;
#ifdef OPEN_CONE
        highest = distance_squared > 0.0 && attenuation > 0.0 ? max(highest, cosine - p_bias) : highest;
#endif
    }
#ifdef OPEN_CONE
    add_horizon(direction, normal, asin(min(highest, 1.0)));
#endif
    return sum;
}

float visibility(vec2 image_px, vec3 position) {
    // NVIDIA leaves a pixel open whose radius is below one pixel.
    vec3 normal = p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
#ifdef OPEN_CONE
    write_open_cone(normal, kHalfPi);
#endif
    if (p_interleaved && p_radius * pixels_per_metre(-position.z) < 1.0) return 1.0;
    vec4 noise = pixel_noise();
    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        occlusion += direction_occlusion(direction, image_px, position, normal, noise.y);
    }
#ifdef OPEN_CONE
    write_horizons(p_directions);
#endif
    occlusion *= p_strength / float(p_directions * p_steps);
    if (p_bias_normalised) occlusion /= 1.0 - p_bias;
    float open = limited_visibility(1.0 - occlusion);
    return p_exponent == 1.0 ? open : pow(open, p_exponent);
}
