// GTAO over the depth surface (lib/gtao.glsl).
#include "contract/ao_pass.glsl"
#include "lib/gtao.glsl"
#include "lib/limits.glsl"

float tap_cosine(vec2 tap_px, SideOfSlice at) { return cosine_of(tap_position(tap_px), at); }

float visibility(vec2 image_px, vec3 position) { return limited_visibility(slices_visibility(image_px, position)); }
