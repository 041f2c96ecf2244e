// A pass that writes visibility. The method defines visibility(); main() is here: background is never shaded and
// stays 1.
#include "contract/inputs.glsl"
#include "lib/upsample.glsl"

layout(location = 0) out float o_visibility;
#if COUNT_FETCHES
layout(location = 1) out float o_fetches;
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
    o_fetches = tap_count;
#endif
}
