// Horizon-based ambient occlusion as Hussain 2022 implements it (section 4.3, appendix).
// V = 1/N_d sum of 1 - darkness · sat(W (sin h - sin t)): h the largest elevation among the samples in range, W = 1 -
// (d/R)² at the last sample in range, whether or not it made the horizon. The steps are fixed in uv.
#include "contract/ao_pass.glsl"
#include "lib/frame.glsl"
#include "lib/horizon.glsl"
#include "lib/noise.glsl"

// Twice the first two channels less 1: a vector in the square, whose angle turns the directions.
mat2 direction_rotation(vec2 vector) {
    if (p_rotation == rotation_unit) vector = normalize(vector);
    vector.y *= kHandedness;  // mirrored, it turns the other way
    return mat2(vector.x, -vector.y, vector.y, vector.x);
}

float tangent_angle(vec2 direction, vec3 tangent, vec3 normal) {
    if (p_tangent == tangent_plane) return elevation(tangent) + p_bias;
    return acos(clamp(dot(view_of_image_direction(direction), normal), -1.0, 1.0)) - kHalfPi + p_bias;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec4 noise = pixel_noise();
    mat2 turn = direction_rotation(noise.xy * 2.0 - 1.0);
    vec2 step_px = p_step_uv * (p_aspect == aspect_corrected ? u_size_px.yy : u_size_px);
    float first = p_jitter ? 1.0 + noise.z : 1.0;

    float sum = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = turn * image_direction(i, p_directions, 0.0);
        Slice slice = slice_along(direction, normal, line_of_sight);
        float tangent = tangent_angle(direction, slice.tangent, normal);
        float sin_horizon = -1.0;  // of the samples' elevations, which lie in [-π/2, π/2]
        float last_distance_squared = 0.0;
#pragma unroll
        for (int j = 0; j < p_steps; ++j) {
            vec3 tap = tap_position(image_px + direction * step_px * (float(j) + first));
            vec3 v = into_slice(tap - position, slice);
            float distance_squared = dot(v, v);
            bool in_range = distance_squared > 0.0 && distance_squared < p_radius * p_radius;
            last_distance_squared = in_range ? distance_squared : last_distance_squared;
            float sin_elevation = v.z * inversesqrt(distance_squared);
            sin_horizon = in_range && sin_elevation > sin_horizon ? sin_elevation : sin_horizon;
        }
        float attenuation = 1.0 - last_distance_squared / (p_radius * p_radius);
        // The bias can lift the tangent beyond π/2, above any sample.
        float rise = tangent < kHalfPi ? max(sin_horizon - sin(tangent), 0.0) : 0.0;
        sum += 1.0 - p_darkness * clamp(attenuation * rise, 0.0, 1.0);
    }
    float mean = sum / float(p_directions);
    return mean < 0.0 ? 0.0 : mean;  // max() would make an open pixel of NaN
}
