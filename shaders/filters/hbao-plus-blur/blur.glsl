// One direction of NVIDIA's blur: taps at 1, 2 and 3.5 pixels on each side, the last between two pixels, with weights
// 2^(-i²/2σ² - (Δz sharpness)²); Δz is what is left of the depth's difference when the slope to the nearest tap is taken off.
#include "contract/filter_pass.glsl"

// Of visibility and depth, `tap` pixels along `step`; between two pixels their mean.
vec2 value_and_depth(ivec2 texel, ivec2 step, int tap, bool between) {
    vec2 near = vec2(tap_visibility(texel + tap * step), filter_depth(texel + tap * step));
    if (!between) return near;
    return 0.5 * (near + vec2(tap_visibility(texel + (tap + 1) * step), filter_depth(texel + (tap + 1) * step)));
}

// x: the weighted values, y: the weights.
vec2 side(ivec2 texel, ivec2 step, float depth) {
    float sigma = 0.5 * float(p_radius_px + 1), slope = filter_depth(texel + step) - depth;
    vec2 sum = vec2(0.0);
    int inner = p_radius_px / 2;
    for (int i = 1; i <= p_radius_px; i += i <= inner ? 1 : 2) {
        vec2 tap = value_and_depth(texel, step, i, i > inner);
        float difference = (tap.y - slope * float(i) - depth) * p_sharpness;
        float weight = exp2(-float(i * i) / (2.0 * sigma * sigma) - difference * difference);
        sum += weight * vec2(tap.x, 1.0);
    }
    return sum;
}

float blurred(ivec2 texel, ivec2 step) {
    float depth = centre_linear_depth();
    vec2 sum = vec2(tap_visibility(texel), 1.0) + side(texel, step, depth) + side(texel, -step, depth);
    return sum.x / sum.y;
}
