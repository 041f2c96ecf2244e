#include "blur.glsl"

// The mean with the four diagonal neighbours.
float filtered(ivec2 texel) {
    vec3 normal = normal_at(texel);
    vec2 sum = vec2(tap_visibility(texel), 1.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 tap = texel + 2 * ivec2(i & 1, i >> 1) - 1;
        sum += weighted(tap_visibility(tap), normal_at(tap), normal, 1.0);
    }
    return sum.x / sum.y;
}
