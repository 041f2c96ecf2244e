#include "blur.glsl"

float filtered(ivec2 texel) { return blurred(texel, ivec2(0, 1)); }
