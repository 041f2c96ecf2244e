// Σ c w / Σ w over the taps within `reach` of a texel.
#include "contract/filter_pass.glsl"

vec3 normal_at(ivec2 texel) {
    return texelFetch(u_normal_geometric, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).xyz;
}

// From the camera.
float radial_distance(ivec2 texel) { return length(view_position(texel_centre(texel), filter_depth(texel))); }

float surface_weight(ivec2 tap, vec3 normal, float radial) {
    float by_normal = p_weights == weights_depth ? 1.0 : pow(0.5 * dot(normal, normal_at(tap)) + 0.5, p_k_n);
    float difference = abs(radial - radial_distance(tap)) / p_distance_unit;
    float by_depth = p_weights == weights_normal ? 1.0 : pow(1.0 / (1.0 + difference), p_k_d);
    return is_background(filter_depth(tap)) ? 0.0 : by_normal * by_depth;
}

float weighted_mean(ivec2 texel, ivec2 reach) {
    vec3 normal = normal_at(texel);
    float radial = radial_distance(texel);
    float sigma = 0.5 * float(p_taps);
    float sum = 0.0, weights = 0.0;
    for (int y = -reach.y; y <= reach.y; ++y) {
        for (int x = -reach.x; x <= reach.x; ++x) {
            ivec2 tap = texel + ivec2(x, y);
            float kernel_weight = p_kernel == kernel_box ? 1.0 : exp(-float(x * x + y * y) / (2.0 * sigma * sigma));
            // The centre itself always counts, whatever rounding makes of its own normal.
            float weight = x == 0 && y == 0 ? 1.0 : kernel_weight * surface_weight(tap, normal, radial);
            sum += weight * tap_visibility(tap);
            weights += weight;
        }
    }
    return sum / weights;
}
