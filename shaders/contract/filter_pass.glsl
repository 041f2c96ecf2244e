// A filter's pass: the filter defines filtered(); main() is here: background stays 1.
#include "contract/inputs.glsl"

uniform sampler2D u_visibility;  // to be filtered

layout(location = 0) out float o_visibility;

// Clamp to edge outside of the picture.
float tap_visibility(ivec2 texel) {
    return texelFetch(u_visibility, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).r;
}

// Linear depth, the same.
float filter_depth(ivec2 texel) {
    return texelFetch(u_linear_depth, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).r;
}

float filtered(ivec2 texel);

void main() {
    if (is_background(centre_linear_depth())) discard;
    o_visibility = filtered(centre_texel());
}
