#include "blur.glsl"
#include "lib/limits.glsl"

float filtered(ivec2 texel) { return pow(limited_visibility(blurred(texel, ivec2(0, 1))), p_exponent); }
