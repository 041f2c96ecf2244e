#include "bilateral.glsl"

float filtered(ivec2 texel) { return weighted_mean(texel, ivec2(p_separated ? 0 : p_taps, p_taps)); }
