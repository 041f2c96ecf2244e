// A filter's pass: the filter defines filtered(); main() is here: background stays 1.
#include "contract/inputs.glsl"

uniform sampler2D u_visibility;  // to be filtered

layout(location = 0) out float o_visibility;

// Clamp to edge outside of the picture.
float tap_visibility(ivec2 texel) {
    return texelFetch(u_visibility, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).r;
}

// Bilinear, at a place between the texels' centres.
float visibility_between(vec2 image_px) {
    vec2 corner = floor(image_px - 0.5), fraction = image_px - 0.5 - corner;
    ivec2 texel = ivec2(corner);
    float above = mix(tap_visibility(texel), tap_visibility(texel + ivec2(1, 0)), fraction.x);
    float below = mix(tap_visibility(texel + ivec2(0, 1)), tap_visibility(texel + 1), fraction.x);
    return mix(above, below, fraction.y);
}

// Linear depth, of the nearest texel inside too.
float filter_depth(ivec2 texel) {
    return texelFetch(u_linear_depth, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).r;
}

float filtered(ivec2 texel);

void main() {
    if (is_background(centre_linear_depth())) discard;
    o_visibility = filtered(centre_texel());
}
