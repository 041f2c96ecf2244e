#include "level.glsl"

float visibility(vec2 image_px, vec3 position) {
    float own = level_visibility(image_px, position), coarser = upsampled_visibility();
    return p_join == join_max ? min(own, coarser) : own * coarser;
}
