// A pass that writes visibility. The method defines visibility(); main() is here: background is never shaded and
// stays 1.
#include "contract/inputs.glsl"
#include "lib/upsample.glsl"

layout(location = 0) out float o_visibility;
#if COUNT_FETCHES
layout(location = 1) out float o_fetches;

// llvmpipe ends loops without a word when a pixel's have turned 65,535 times in all. From then on every loop ends after
// its first turn: this one, whose length no compiler knows, tells.
bool loops_were_cut_short() {
    float turns = 0.0, length = u_size_px.x > 0.0 ? 3.0 : 4.0;
    for (float i = 0.0; i < length; i += 1.0) turns += length;
    return turns < length * length;
}
const float kLoopsCutShort = -2.0;
#endif

// Of the surface at this image position and view-space point: 1 open, 0 closed.
float visibility(vec2 image_px, vec3 position);

void main() {
    float depth = centre_linear_depth();
    if (is_background(depth)) discard;
#if DUAL
    if (coarser_range() < kDualThreshold) discard;  // the coarse picture, brought up, is there already
#endif
    vec2 image_px = texel_centre(centre_texel());
    o_visibility = visibility(image_px, view_position(image_px, depth));
#if COUNT_FETCHES
    o_fetches = loops_were_cut_short() ? kLoopsCutShort : tap_count;
#endif
}
