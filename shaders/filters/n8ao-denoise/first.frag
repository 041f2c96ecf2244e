#include "disc_mean.glsl"

float filtered(ivec2 texel) { return disc_mean(texel, pixel_noise().w); }
