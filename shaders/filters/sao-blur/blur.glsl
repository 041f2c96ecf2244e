// One direction of SAO's blur: nine taps two pixels apart, weighted by a Gaussian over a floor and by nearness in depth.
#include "contract/filter_pass.glsl"

float blurred(ivec2 texel, ivec2 axis) {
    // The Gaussian is normalised over the nine taps; the centre alone has no floor under it.
    float total = 1.0;
    for (int i = 1; i <= p_taps; ++i) total += 2.0 * exp(-float(i * i) / (2.0 * p_sigma * p_sigma));
    float depth = centre_linear_depth();
    float weights = 1.0 / total, sum = weights * tap_visibility(texel);
    for (int i = -p_taps; i <= p_taps; ++i) {
        if (i == 0) continue;
        ivec2 tap = texel + axis * (i * p_spacing_px);
        float gaussian = exp(-float(i * i) / (2.0 * p_sigma * p_sigma)) / total;
        float near = max(1.0 - abs(filter_depth(tap) - depth) / p_depth_step, 0.0);
        float weight = (p_floor + gaussian) * near;
        sum += weight * tap_visibility(tap);
        weights += weight;
    }
    return sum / weights;
}
