// Alchemy's estimator on a spiral (Gravås 2013, appendix B): one turn, rotated by a linear function of the pixel.
#include "contract/ao_pass.glsl"
#include "lib/alchemy.glsl"
#include "lib/spiral.glsl"

vec2 spiral_radius_px(float depth) {
    vec2 limit = p_max_screen_radius * u_size_px.yy;
    if (p_tap_radius == tap_radius_projected) return min(vec2(p_radius * pixels_per_metre(depth)), limit);
    return min(p_radius / depth, p_max_screen_radius) * u_size_px;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec2 radius_px = spiral_radius_px(-position.z);
    float turn = p_rotation == rotation_none ? 0.0 : dot(vec2(noise_texel()) + 0.5, vec2(2.3734372915, 3.58540627421));
    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 v = surface_at(image_px + radius_px * spiral_tap(i, p_samples, 1.0, turn), p_tap_position == tap_position_place) - position;
        sum += alchemy_obscurance(v, normal, position.z, p_beta, p_epsilon);
    }
    return pow(max(0.0, 1.0 - 2.0 * p_sigma / float(p_samples) * sum), p_kappa);
}
