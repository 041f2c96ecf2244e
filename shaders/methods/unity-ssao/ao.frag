// Unity's SSAO: Alchemy's estimator (McGuire et al. 2011) over the surfaces that random points of the hemisphere project
// to, times the radius; the obscurance's power, less with the square of what is left of the falloff's distance.
#include "contract/ao_pass.glsl"
#include "lib/alchemy.glsl"
#include "lib/constants.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

// Of the i-th sample, in [0,1). Unity counts rows from below.
float sample_noise(int i) {
    if (p_noise == noise_hash) return hash_noise(noise_texel(), uint(i)).x;
    if (p_noise != noise_interleaved_gradient) return pixel_noise().x;
    vec2 at = texel_centre(noise_texel());
    at.y = u_size_px.y - at.y;
    return interleaved_gradient(at + float(i) * vec2(2.083, 4.867));
}

// A point of the unit ball: its random height and turn are moved by the noise.
vec3 ball_point(int i) {
    float noise = sample_noise(i);
    float height = 2.0 * fract(length(k_numbers[i].xy) + noise) - 1.0;
    float turns = atan(k_numbers[i].y, k_numbers[i].x) / kTwoPi + noise;
    // Fractions of whole turns: the sine of a large angle is inexact.
    float angle = kTwoPi * fract(p_points == points_shell_lerp ? 100.0 * turns : turns);
    float part = float(i) / float(p_samples);
    float distance = p_points == points_shell_lerp ? mix(0.1, 1.0, part * part) : sqrt(float(i + 1) / float(p_samples));
    float across = sqrt(1.0 - height * height);
    return distance * mirrored(vec3(across * cos(angle), across * sin(angle), height));
}

float obscurance(vec3 point, vec3 position, vec3 normal, float reach) {
    vec2 tap_px = clamp(image_of(point), vec2(0.0), u_size_px);
    float depth = tap_linear_depth(inside_picture(tap_px));
    bool inside = abs(-point.z - depth) < reach && !is_background(depth);
    vec3 v = view_position(tap_px, depth) - position;
    return inside ? alchemy_obscurance(v, normal, position.z, p_beta, p_epsilon) : 0.0;
}

float visibility(vec2 image_px, vec3 position) {
    if (-position.z > p_falloff) return 1.0;
    vec3 normal = p_normal_source == normal_source_smooth ? centre_normal_smooth() : centre_normal_geometric();
    float reach = p_radius * p_radius_factor, sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 offset = ball_point(i);
        offset = dot(offset, normal) < 0.0 ? -offset : offset;
        sum += obscurance(position + reach * offset, position, normal, reach);
    }
    float near = 1.0 + position.z / p_falloff;
    float occlusion = sum * reach * p_intensity * near * near / float(p_samples);
    return 1.0 - pow(limited_visibility(occlusion), p_contrast);
}
