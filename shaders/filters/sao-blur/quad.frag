// The mean over each block of 2x2 pixels, first of its rows, then of both, where depth hardly changes.
#include "contract/filter_pass.glsl"

// The mean of the two pixels of a block's row, or the pixel's own value beside an edge.
float row_mean(ivec2 texel) {
    ivec2 beside = ivec2(texel.x ^ 1, texel.y);
    bool level = abs(filter_depth(beside) - filter_depth(texel)) < p_quad_step;
    return level ? 0.5 * (tap_visibility(texel) + tap_visibility(beside)) : tap_visibility(texel);
}

float filtered(ivec2 texel) {
    ivec2 beside = ivec2(texel.x, texel.y ^ 1);
    bool level = abs(filter_depth(beside) - filter_depth(texel)) < p_quad_step;
    return level ? 0.5 * (row_mean(texel) + row_mean(min(beside, ivec2(u_size_px) - 1))) : row_mean(texel);
}
