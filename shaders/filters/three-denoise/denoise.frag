// three.js' denoiser of its GTAOPass: the mean of the pixel and of taps around it, weighted by likeness of value, by their
// distance to its tangent plane and by their normals.
#include "contract/filter_pass.glsl"
#include "lib/constants.glsl"
#include "lib/noise.glsl"

vec3 normal_at(ivec2 texel) {
    vec2 inside = vec2(clamp(texel, ivec2(0), ivec2(u_size_px) - 1));
    return p_normal_source == normal_source_smooth ? picture_texel(u_normal_smooth, inside).xyz
                                       : picture_texel(u_normal_geometric, inside).xyz;
}

// The i-th of `samples` taps, pixels with y upwards: on a circle, a pixel's length and the growing part of the radius.
vec2 ring_tap(int i) {
    float angle = kTwoPi * float(p_rings * i) / float(p_samples);
    float part = pow(float(i) / float(max(p_samples - 1, 1)), p_radius_exponent);
    return (1.0 + part * (p_radius_px - 1.0)) * vec2(cos(angle), sin(angle));
}

float likeness(float value, float centre, ivec2 tap, vec2 tap_px, vec3 position, vec3 normal) {
    float depth = filter_depth(tap);
    float beside = abs(dot(view_position(tap_px, depth) - position, normal));
    float by_value = max(1.0 - abs(value - centre) / p_value_phi, 0.0);
    float by_plane = max(1.0 - beside / p_depth_phi, 0.0);
    float by_normal = pow(max(dot(normal, normal_at(tap)), 0.0), p_normal_phi);
    return is_background(depth) ? 0.0 : by_value * by_plane * by_normal;
}

float filtered(ivec2 texel) {
    vec2 image_px = texel_centre(texel);
    vec3 position = view_position(image_px, centre_linear_depth()), normal = normal_at(texel);
    float turn = kTwoPi * pixel_noise().x;
    // As published, no rotation: both rows begin with the sine.
    mat2 turned = mat2(sin(turn), -cos(turn), sin(turn), cos(turn));
    float centre = tap_visibility(texel), sum = centre, weights = 1.0;
    for (int i = 0; i < p_samples; ++i) {
        vec2 tap_px = image_px + vec2(1.0, -1.0) * (turned * ring_tap(i));
        float value = visibility_between(tap_px);
        float weight = likeness(value, centre, ivec2(floor(tap_px)), tap_px, position, normal);
        sum += weight * value;
        weights += weight;
    }
    return sum / weights;
}
