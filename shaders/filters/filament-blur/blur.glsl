// One direction of Filament's blur: Gaussian taps two pixels apart, less by the square of their difference in depth.
#include "contract/filter_pass.glsl"

float blurred(ivec2 texel, ivec2 axis) {
    float depth = centre_linear_depth(), sum = tap_visibility(texel), weights = 1.0;
    for (int i = -p_taps; i <= p_taps; ++i) {
        if (i == 0) continue;
        ivec2 tap = texel + axis * (i * p_spacing_px);
        float apart = (filter_depth(tap) - depth) / p_edge_distance;
        float weight = exp(-float(i * i) / (2.0 * p_sigma * p_sigma)) * max(1.0 - apart * apart, 0.0);
        sum += weight * tap_visibility(tap);
        weights += weight;
    }
    return sum / weights;
}
