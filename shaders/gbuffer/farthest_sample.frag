// The window depth of the farthest of a texel's samples: what lies behind it changes none of them. A little farther, by more
// than the rounding of a fragment's own depth.
#include "contract/view.glsl"

uniform sampler2DArray u_depth_layers;
uniform int u_first_texture;

const float kRounding = 4e-6;

float window_of_depth(float depth) {
#if ORTHOGRAPHIC
    return (depth - u_near) / (u_far - u_near);
#else
    return (1.0 / u_near - 1.0 / depth) / (1.0 / u_near - 1.0 / u_far);
#endif
}

void main() {
    float farthest = 0.0;
    for (int i = 0; i < SAMPLES; ++i)
        farthest = max(farthest, texelFetch(u_depth_layers, ivec3(gl_FragCoord.xy, u_first_texture + i / 4), 0)[i % 4]);
    gl_FragDepth = is_background(farthest) ? 1.0 : min(window_of_depth(farthest) + kRounding, 1.0);
}
