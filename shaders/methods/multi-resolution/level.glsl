// One level of the multi-resolution method (Hoang and Low 2010): taps of this level's pixels around the centre.
#include "contract/ao_pass.glsl"
#include "lib/limits.glsl"

float level_visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float sum = 0.0, taps = 0.0;
    for (int y = -p_window; y <= p_window; ++y) {
        for (int x = -p_window; x <= p_window; ++x) {
            // A checkerboard: half of the taps, every direction.
            if (((x + y) & 1) != 0 || (x == 0 && y == 0)) continue;
            vec3 v = tap_position(image_px + vec2(x, y) * float(SCALE)) - position;
            float distance_squared = dot(v, v);
            float weight = max(1.0 - distance_squared / (p_radius * p_radius), 0.0);
            sum += distance_squared > 0.0 ? weight * max(dot(v, normal) * inversesqrt(distance_squared), 0.0) : 0.0;
            taps += 1.0;
        }
    }
    return limited_visibility(1.0 - p_strength * sum / taps);
}
