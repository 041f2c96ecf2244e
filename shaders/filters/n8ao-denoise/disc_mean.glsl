// One turn of N8AO's denoiser: the mean of the pixel and of taps on a spiral around it, weighted by their distance to its
// tangent plane and by their normals.
#include "contract/filter_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"

const float kFalloffScale = 0.2;
const float kRings = 11.0;

vec3 normal_at(ivec2 texel) {
    vec2 inside = vec2(clamp(texel, ivec2(0), ivec2(u_size_px) - 1));
    return p_normal_source == normal_source_from_depth ? picture_texel(u_normal_from_depth_accurate, inside).xyz
                                           : picture_texel(u_normal_geometric, inside).xyz;
}

// Of `samples` points, the radius growing by the power 3/4.
vec2 disc_tap(int i) {
    float angle = kTwoPi * kRings * float(i) / float(p_samples);
    return pow(float(i + 1) / float(p_samples), 0.75) * vec2(cos(angle), -sin(angle));
}

float disc_mean(ivec2 texel, float turn) {
    vec2 image_px = texel_centre(texel);
    vec3 position = view_position(image_px, centre_linear_depth()), normal = normal_at(texel);
    mat2 turned = rotation(kTwoPi * turn);
    float fade = kFalloffScale * p_radius * p_falloff;
    float sum = tap_visibility(texel), weights = 1.0;
    for (int i = 0; i < p_samples; ++i) {
        vec2 tap_px = image_px + p_radius_px * (turned * disc_tap(i));
        ivec2 tap = ivec2(floor(tap_px));
        float depth = filter_depth(tap);
        float beside = abs(dot(view_position(tap_px, depth) - position, normal));
        float weight = is_background(depth) ? 0.0 : exp(-beside / fade) * max(dot(normal, normal_at(tap)), 0.0);
        sum += weight * visibility_between(tap_px);
        weights += weight;
    }
    float mean = sum / weights;
    return mean == 0.0 ? 1.0 : mean;  // as published
}
