// HBAO+ (Vermeer 2020, algorithm 3): O = 1/(N_d N_s) sum of W(|v|) max(n·v/|v| - bias, 0), W = max(1 - (d/R)², 0).
#include "contract/ao_pass.glsl"
#include "lib/horizon.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec4 noise = pixel_noise();
    float step_px = p_radius * pixels_per_metre(-position.z) / float(p_steps + 1);

    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
#pragma unroll
        for (int j = 0; j < p_steps; ++j) {
            vec3 v = tap_position(image_px + direction * (float(j + 1) + noise.y) * step_px) - position;
            float distance_squared = dot(v, v);
            float attenuation = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
            float cosine = dot(v, normal) * inversesqrt(distance_squared);
            float weight = j == 0 ? p_first_weight : 1.0;
            occlusion += distance_squared > 0.0 ? weight * attenuation * max(cosine - p_bias, 0.0) : 0.0;
        }
    }
    occlusion *= p_strength / float(p_directions * p_steps);
    if (p_bias_normalised) occlusion /= 1.0 - p_bias;
    float open = limited_visibility(1.0 - occlusion);
    return p_exponent == 1.0 ? open : pow(open, p_exponent);
}
