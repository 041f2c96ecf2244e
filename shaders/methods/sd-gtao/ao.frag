// GTAO over a stochastic-depth buffer: a tap raises the horizon to the highest of all depths of its texel.
#include "contract/ao_pass.glsl"
#include "contract/depth_layers.glsl"
#include "lib/gtao.glsl"
#include "lib/limits.glsl"

float tap_cosine(vec2 tap_px, SideOfSlice at) {
    float highest = kNoTap;
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        for (int k = 0; k < 4; ++k) {
            float cosine = cosine_of(layer_position(tap_px, depths[k]), at);
            highest = is_background(depths[k]) ? highest : max(highest, cosine);
        }
    }
    return highest;
}

float visibility(vec2 image_px, vec3 position) { return limited_visibility(slices_visibility(image_px, position)); }
