// One direction of the cross-bilateral Gaussian: AO' = Σ AO_i w_i / Σ w_i, w_i = exp(-i²/2σ²) exp(-((d_i - s|i| - d_0)
// sharpness / d_0)²), s the slope d_±1 - d_0 of the tap's side.
#include "contract/filter_pass.glsl"

// A step to another surface is no slope.
float slope_of(float here, float there) { return abs(here) > 4.0 * abs(there) ? there * -1.0 : here; }

float blurred(ivec2 texel, ivec2 step) {
    float depth = centre_linear_depth();
    float sum = tap_visibility(texel), weights = 1.0;
    float ahead = filter_depth(texel + step) - depth, behind = filter_depth(texel - step) - depth;
    for (int side = -1; side <= 1; side += 2) {
        float slope = !p_slope_correction ? 0.0 : (side > 0 ? slope_of(ahead, behind) : slope_of(behind, ahead));
        for (int i = 1; i <= p_taps; ++i) {
            ivec2 tap = texel + side * i * step;
            float difference = (filter_depth(tap) - slope * float(i) - depth) / depth * p_sharpness;
            float weight = exp(-float(i * i) / (2.0 * p_sigma_px * p_sigma_px) - difference * difference);
            sum += weight * tap_visibility(tap);
            weights += weight;
        }
    }
    return sum / weights;
}
