#include "level.glsl"

float visibility(vec2 image_px, vec3 position) { return level_visibility(image_px, position); }
