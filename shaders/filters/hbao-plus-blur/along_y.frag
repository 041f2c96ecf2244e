#include "blur.glsl"
#include "lib/limits.glsl"

float filtered(ivec2 texel) {
    float open = limited_visibility(blurred(texel, ivec2(0, 1)));
    return p_exponent == 1.0 ? open : pow(open, p_exponent);
}
