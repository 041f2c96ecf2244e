// Stochastic-depth SSAO (Vermeer 2020, algorithm 9): of all depths of a point's texel that hide it, the one nearest to the
// pixel's own depth counts.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/shading_normal.glsl"
#include "lib/ssao.glsl"
#include "lib/stochastic_depth.glsl"

vec3 random_direction() {
    float angle = kTwoPi * pixel_noise().x;
    return vec3(cos(angle), sin(angle), 0.0);
}

float hidden_by_layers(vec2 tap_px, vec3 point, vec3 position) {
    float most = 0.0;
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        for (int k = 0; k < 4; ++k) most = max(most, hidden_by(-depths[k], point, position));
    }
    return most;
}

// Whether the nearest layer in front of the point is a front face, and the next behind it a back face.
bool is_inside(vec2 tap_px, vec3 point) {
    bool entered = false;
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        for (int k = 0; k < 4; ++k) {
            float depth = abs(depths[k]);
            if (is_background(depth)) return false;
            bool is_front = depths[k] > 0.0;
            if (!hides(-depth, point, p_bias)) return entered && !is_front;
            entered = is_front;
        }
    }
    return false;
}

float hidden_part(vec3 point, vec3 position) {
    vec2 tap_px = image_of(point);
    if (p_closed_meshes) return is_inside(tap_px, point) ? 1.0 : 0.0;
    if (p_use == use_always) return hidden_by_layers(tap_px, point, position);
    float z = -tap_linear_depth(tap_px), difference = z - position.z;
    if (first_is_enough(difference * difference)) return hidden_by(z, point, position);
    if (skips_by_angle() && !hides(z, point, p_bias)) return 0.0;
    return hidden_by_layers(tap_px, point, position);
}

float visibility(vec2 image_px, vec3 position) {
    return limited_visibility(1.0 - with_strength(hidden_points(position) / float(p_samples)));
}
