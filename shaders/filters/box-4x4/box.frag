#include "contract/filter_pass.glsl"

float filtered(ivec2 texel) {
    float sum = 0.0;
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) sum += tap_visibility(texel + ivec2(x, y));
    }
    return sum / 16.0;
}
