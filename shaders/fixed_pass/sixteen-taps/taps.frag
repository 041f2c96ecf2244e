// The unit of relative cost: sixteen neighbouring reads of depth and next to no arithmetic. Its picture means nothing.
#include "contract/ao_pass.glsl"

float visibility(vec2 image_px, vec3 position) {
    float sum = 0.0;
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) sum += tap_linear_depth(image_px + vec2(float(x), float(y)));
    }
    return clamp(sum / (16.0 * u_far), 0.0, 1.0);
}
