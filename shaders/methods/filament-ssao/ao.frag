// Filament's SSAO (Google): Alchemy's estimator over a spiral whose radius grows by the square, in depth mips; the root of
// the obscurance, and the visibility squared.
#include "contract/ao_pass.glsl"
#include "lib/alchemy.glsl"
#include "lib/constants.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

// The estimator peaks at this part of the radius.
const float kPeak = 0.1;

// The i-th tap, in pixels: turned and moved outward by the noise, at least a pixel away.
vec2 tap_offset(int i, float noise, float radius_px) {
    float count = float(p_samples) - 0.5;
    float angle = kTwoPi * (float(i) / count * float(p_turns) + 2.4 * noise), part = (float(i) + noise + 0.5) / count;
    return max(part * part * radius_px, 1.0) * mirrored(vec2(cos(angle), -sin(angle)));
}

float obscurance(vec3 v, vec3 normal, float depth) {
    float distance_squared = dot(v, v), height = dot(v, normal);
    float within = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
    float least = sin(p_least_horizon);
    if (height * height < distance_squared * least * least) return 0.0;
    return within * within * alchemy_obscurance(v, normal, -depth, p_bias, kPeak * kPeak * p_radius * p_radius);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal =
        p_normal_source == normal_source_from_depth ? centre_normal_from_depth_accurate() : centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    float noise = p_noise == noise_interleaved_gradient ? interleaved_gradient(texel_centre(noise_texel()))
                                                        : pixel_noise().x;
    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 offset_px = tap_offset(i, noise, radius_px), tap_px = image_px + offset_px;
        int mip = clamp(int(floor(log2(length(offset_px)) + 1e-4)) - 3, 0, kDepthMipLevels - 1);
        vec3 v = view_position(tap_px, tap_mip_depth(inside_picture(tap_px), mip)) - position;
        sum += obscurance(v, normal, -position.z);
    }
    float occlusion = sqrt(sum * kTwoPi * kPeak * p_radius * p_intensity / float(p_samples));
    return pow(limited_visibility(1.0 - occlusion), 2.0 * p_power);
}
