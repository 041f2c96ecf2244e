// One direction of the blur: taps between two pixels, two pixels apart, weighted by a Gaussian where depth is near.
#include "contract/filter_pass.glsl"

float blurred(ivec2 texel, ivec2 axis) {
    float sigma = 0.5 * float(p_radius_px + 1), depth = centre_linear_depth();
    float sum = tap_visibility(texel), weights = 1.0;
    for (int i = 1; i < p_radius_px; i += 2) {
        for (int side = -1; side <= 1; side += 2) {
            ivec2 near = texel + side * i * axis, far = near + side * axis;
            float apart = 0.5 * (filter_depth(near) + filter_depth(far)) - depth, at = float(i) + 0.5;
            float weight = abs(apart) < p_depth_step ? exp(-at * at / (2.0 * sigma * sigma)) : 0.0;
            sum += weight * 0.5 * (tap_visibility(near) + tap_visibility(far));
            weights += weight;
        }
    }
    return sum / weights;
}
