// Alchemy ambient obscurance (McGuire et al. 2011; Hussain 2022, eq. 15). z is negative in front of the camera: the
// bias z·β lifts the tangent plane toward the viewer.
#include "contract/ao_pass.glsl"
#include "lib/frame.glsl"
#include "lib/constants.glsl"
#include "lib/noise.glsl"

vec2 disc_radius_px(float depth) {
    if (p_tap_radius == tap_radius_projected) return vec2(p_radius * pixels_per_metre(depth));
    return 0.75 * p_radius * p_radius / depth * u_size_px;
}

float obscurance(vec3 v, vec3 normal, float z) {
    float distance_squared = dot(v, v);
    if (p_reject == reject_within_radius && distance_squared > p_radius * p_radius) return 0.0;
    if (p_reject == reject_as_printed && distance_squared > p_radius) return 0.0;
    float height = max(0.0, dot(v, normal) + z * p_beta);
    // Without epsilon, a tap of the pixel itself is 0/0; it obscures nothing.
    return height > 0.0 ? height / (distance_squared + p_epsilon) : 0.0;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec2 radius_px = disc_radius_px(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);

    float sum = 0.0;
    for (int i = 0; i < p_samples; ++i) {
        vec3 v = tap_position(image_px + radius_px * (turn * k_disc[i].xy)) - position;
        sum += obscurance(v, normal, position.z);
    }
    sum *= 2.0 * p_sigma / float(p_samples);
    if (p_exponent_form == exponent_form_as_printed) return max(0.0, 1.0 - pow(sum, p_kappa));
    return pow(max(0.0, 1.0 - sum), p_kappa);
}
