// A pass that writes visibility. The method defines visibility(); main() is here: background is never shaded and
// stays 1.
#include "contract/inputs.glsl"

layout(location = 0) out float o_visibility;
#if COUNT_FETCHES
layout(location = 1) out float o_fetches;
#endif

// Of the surface at this image position and view-space point: 1 open, 0 closed.
float visibility(vec2 image_px, vec3 position);

void main() {
    float depth = centre_linear_depth();
    if (is_background(depth)) discard;
    o_visibility = visibility(gl_FragCoord.xy, view_position(gl_FragCoord.xy, depth));
#if COUNT_FETCHES
    o_fetches = tap_count;
#endif
}
