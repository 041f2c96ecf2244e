#include "contract/filter_pass.glsl"

float filtered(ivec2 texel) {
    float sum = 0.0;
    for (int y = -p_size / 2; y < (p_size + 1) / 2; ++y) {
        for (int x = -p_size / 2; x < (p_size + 1) / 2; ++x) sum += tap_visibility(texel + ivec2(x, y));
    }
    return sum / float(p_size * p_size);
}
