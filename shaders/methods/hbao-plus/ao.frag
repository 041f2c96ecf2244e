// HBAO+ (lib/hbao_plus.glsl) with taps as Vermeer (2020, algorithm 3) spreads them, or as NVIDIA's implementation does.
#include "contract/ao_pass.glsl"
#include "lib/hbao_plus.glsl"
#include "lib/limits.glsl"

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

TapPart tap_part(int j, vec2 direction, vec2 image_px, vec3 position, vec3 normal, float shift) {
    float radius_px = p_radius * pixels_per_metre(-position.z);
    TapPart part = part_of(tapped(image_px, direction * tap_distance_px(j, shift, radius_px)) - position, normal);
    part.occlusion *= j == 0 ? p_first_weight : 1.0;
    return part;
}

float visibility(vec2 image_px, vec3 position) {
    // NVIDIA leaves a pixel open whose radius is below one pixel.
    vec3 normal = shading_normal();
#ifdef OPEN_CONE
    write_open_cone(normal, kHalfPi);
#endif
    if (p_interleaved && p_radius * pixels_per_metre(-position.z) < 1.0) return 1.0;
    float occlusion = tapped_occlusion(image_px, position, normal);
    occlusion *= p_strength / float(p_directions * p_steps);
    if (p_bias_normalised) occlusion /= 1.0 - p_bias;
    float open = limited_visibility(1.0 - occlusion);
    return p_exponent == 1.0 ? open : pow(open, p_exponent);
}
