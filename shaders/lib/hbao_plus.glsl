// HBAO+: O = 1/(N_d N_s) sum of W(|v|) max(n·v/|v| - bias, 0), W = max(1 - (d/R)², 0) (Vermeer 2020, algorithm 3). The
// method says in tap_part() what a tap finds.
#include "contract/inputs.glsl"
#include "lib/horizon.glsl"
#include "lib/noise.glsl"
#include "lib/open_horizon.glsl"
#include "lib/shading_normal.glsl"

struct TapPart {
    float occlusion;
    float height;  // cosine to the normal over the bias, where the tap lies within the radius; else 0 or less
};

// Of the j-th tap in this direction.
TapPart tap_part(int j, vec2 direction, vec2 image_px, vec3 position, vec3 normal, float shift);

TapPart part_of(vec3 v, vec3 normal) {
    float distance_squared = dot(v, v);
    float attenuation = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
    float cosine = dot(v, normal) * inversesqrt(distance_squared);
    bool is_tap = distance_squared > 0.0;  // not the pixel itself
    return TapPart(is_tap ? attenuation * max(cosine - p_bias, 0.0) : 0.0,
                   is_tap && attenuation > 0.0 ? cosine - p_bias : 0.0);
}

float direction_occlusion(vec2 direction, vec2 image_px, vec3 position, vec3 normal, float shift) {
    float sum = 0.0;
#ifdef OPEN_CONE
    float highest = 0.0;
#endif
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        TapPart part = tap_part(j, direction, image_px, position, normal, shift);
        sum += part.occlusion;
#ifdef OPEN_CONE
        highest = max(highest, part.height);
#endif
    }
#ifdef OPEN_CONE
    add_horizon(direction, normal, asin(min(highest, 1.0)));
#endif
    return sum;
}

// The sum over all taps.
float tapped_occlusion(vec2 image_px, vec3 position, vec3 normal) {
    vec4 noise = pixel_noise();
    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        occlusion += direction_occlusion(direction, image_px, position, normal, noise.y);
    }
#ifdef OPEN_CONE
    write_horizons(p_directions);
#endif
    return occlusion;
}
