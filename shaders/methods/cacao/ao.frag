// Adaptive screen-space ambient occlusion (Strugar 2016; AMD 2020), its estimator.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"

// Obscurance and weight of a tap.
vec2 weighed(vec3 v, vec3 normal) {
    float distance_squared = dot(v, v);
    float cosine = distance_squared > 0.0 ? dot(v, normal) * inversesqrt(distance_squared) : 0.0;
    float obscurance = max(0.0, cosine - p_horizon_threshold) * max(0.0, 1.0 - distance_squared / (p_radius * p_radius));
    float weight = 1.0 - p_halo + p_halo * clamp(2.0 - max(v.z, 0.0) / p_radius, 0.0, 1.0);
    return vec2(obscurance * weight, weight);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);
    vec2 sum = vec2(0.0);
#pragma unroll
    for (int i = 0; i < p_pairs; ++i) {
        vec2 offset_px = radius_px * (turn * k_disc[i].xy);
        sum += weighed(tap_position(image_px + offset_px) - position, normal);
        sum += weighed(tap_position(image_px - offset_px) - position, normal);
    }
    // With halo = 1 the weights may vanish: then nothing is near enough to obscure.
    float obscurance = sum.y > 0.0 ? min(p_strength * sum.x / sum.y, p_limit) : 0.0;
    return pow(1.0 - obscurance, p_power);
}
