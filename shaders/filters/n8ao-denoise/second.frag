#include "disc_mean.glsl"

float filtered(ivec2 texel) {
    float open = disc_mean(texel, pixel_noise().z);
    return p_exponent == 1.0 ? open : pow(open, p_exponent);
}
