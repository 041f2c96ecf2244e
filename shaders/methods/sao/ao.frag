// Scalable ambient obscurance (McGuire, Mara and Luebke 2012). R^6 is divided out of the sum, for small radii's sake.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/spiral.glsl"

float obscurance(vec3 v, vec3 normal) {
    float distance_squared = dot(v, v);
    float within = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
    float height = max(dot(v, normal) - p_beta, 0.0);
    // Without epsilon and beta, a tap of the pixel itself is 0/0; it obscures nothing.
    return height > 0.0 ? within * within * within * height / (distance_squared + p_epsilon) : 0.0;
}

// The reference implementation's angle of a pixel is ((3x) xor (y + xy)) 10 radians: as a part of a turn, its integer
// taken apart so that single precision keeps the fraction.
float pixel_hash_turn() {
    ivec2 texel = noise_texel();
    int hash = (3 * texel.x) ^ (texel.y + texel.x * texel.y);
    return fract(float(hash >> 12) * 0.98646904 + float(hash & 4095) * 1.59154943);
}

vec3 tapped(vec2 image_px, vec2 offset_px) {
    float tap_radius_px = max(length(offset_px), 1.0);
    int mip = clamp(int(floor(log2(tap_radius_px))) - p_full_radius_log2, 0, kDepthMipLevels - 1);
    if (p_taps == taps_texel) return tap_mip_position(image_px + offset_px, mip);
    // The reference implementation cuts the offset's fractions off, and clamps to the edge.
    vec2 tap_px = image_px + trunc(offset_px);
    return view_position(tap_px, tap_mip_depth(inside_picture(tap_px), mip));
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    float turn = p_noise == noise_pixel_hash ? pixel_hash_turn() : pixel_noise().x;
    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 offset_px = radius_px * spiral_tap(i, p_samples, float(p_turns), kTwoPi * turn);
        sum += obscurance(tapped(image_px, offset_px) - position, normal);
    }
    return limited_visibility(1.0 - 5.0 * p_intensity / float(p_samples) * sum);
}
