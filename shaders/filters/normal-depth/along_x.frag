#include "bilateral.glsl"

float filtered(ivec2 texel) { return p_separated ? weighted_mean(texel, ivec2(p_taps, 0)) : tap_visibility(texel); }
