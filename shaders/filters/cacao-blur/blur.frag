// The mean of the pixel, by a half, and its four neighbours in the smaller picture, as far as no edge lies between.
#include "filters/cacao-blur/edges.glsl"

float filtered(ivec2 texel) {
    vec4 open = stored_open(texel);
    float sum = 0.5 * tap_visibility(texel), weights = 0.5;
    for (int i = 0; i < 4; ++i) {
        sum += open[i] * tap_visibility(texel + kInterleaved * ivec2(side_offset(i)));
        weights += open[i];
    }
    return sum / weights;
}
