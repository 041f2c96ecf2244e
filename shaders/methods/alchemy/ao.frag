// Alchemy ambient obscurance (McGuire et al. 2011; Hussain 2022, eq. 15).
#include "contract/ao_pass.glsl"
#include "lib/alchemy.glsl"
#include "lib/frame.glsl"
#include "lib/constants.glsl"
#include "lib/noise.glsl"

vec2 disc_radius_px(float depth) {
    if (p_tap_radius == tap_radius_projected) return vec2(p_radius * pixels_per_metre(depth));
    return 0.75 * p_radius * p_radius / depth * u_size_px;
}

bool rejected(vec3 v) {
    if (p_reject == reject_within_radius) return dot(v, v) > p_radius * p_radius;
    return p_reject == reject_as_printed && dot(v, v) > p_radius;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
    vec2 radius_px = disc_radius_px(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);

    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 v = surface_at(image_px + radius_px * (turn * k_disc[i].xy), p_tap_position == tap_position_place) - position;
        sum += rejected(v) ? 0.0 : alchemy_obscurance(v, normal, position.z, p_beta, p_epsilon);
    }
    sum *= 2.0 * p_sigma / float(p_samples);
    if (p_exponent_form == exponent_form_as_printed) return max(0.0, 1.0 - pow(sum, p_kappa));
    return pow(max(0.0, 1.0 - sum), p_kappa);
}
