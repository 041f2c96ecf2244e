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

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    float turn = kTwoPi * pixel_noise().x;
    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 offset_px = radius_px * spiral_tap(i, p_samples, float(p_turns), turn);
        float tap_radius_px = max(length(offset_px), 1.0);
        int mip = clamp(int(floor(log2(tap_radius_px))) - p_full_radius_log2, 0, kDepthMipLevels - 1);
        sum += obscurance(tap_mip_position(image_px + offset_px, mip) - position, normal);
    }
    return limited_visibility(1.0 - 5.0 * p_intensity / float(p_samples) * sum);
}
