// HBAO over the depth surface (lib/hbao.glsl), or as NVIDIA's pixel shader marches it.
#include "contract/ao_pass.glsl"
#include "lib/hbao.glsl"
#include "lib/limits.glsl"
#include "nvidia.glsl"

Rise best_rise(vec2 tap_px, March march) { return rise_of(tap_position(tap_px), march); }

float visibility(vec2 image_px, vec3 position) {
    if (p_form == form_nvidia) return nvidia_visibility(image_px, position);
    return limited_visibility(1.0 - horizon_occlusion(image_px, position));
}
