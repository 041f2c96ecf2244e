#include "blur.glsl"
#include "lib/limits.glsl"

float filtered(ivec2 texel) {
    float open = blurred(texel, ivec2(0, 1));
    if (p_strength == 1.0 && p_exponent == 1.0) return open;
    float occlusion = limited_visibility((1.0 - open) * p_strength);
    return 1.0 - pow(occlusion, p_exponent);
}
