// three.js' GTAOPass: horizons in slices through the view vector, raised by taps along a direction of the picture plane,
// and the cosine-weighted arc between them about the normal in the slice, which is not weighted by its length.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/slice.glsl"

// A turn in (0,1] for each of 5x5 pixels, counted from the lower left: the numbers of a magic square by the Siamese method,
// 5 ((4i + 4j + 1) mod 5) + (3i + 4j + 3) mod 5 + 1 in row i and column j.
float magic_square_turn() {
    ivec2 texel = noise_texel();
    int row = (int(u_size_px.y) - 1 - texel.y) % 5, column = texel.x % 5;
    return float(5 * ((4 * row + 4 * column + 1) % 5) + (3 * row + 4 * column + 3) % 5 + 1) / 25.0;
}

// Cosine to the view vector of the highest tap along `reach` (m, in the picture plane), from `cosine` on. Later taps raise
// it by a part of the difference only.
float raised_horizon(float cosine, vec3 position, vec3 view, vec3 reach) {
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        vec3 offset = reach * pow(float(j + 1) / float(p_steps), p_distance_exponent);
        vec2 tap_px = image_of(position + offset);
        float depth = tap_linear_depth(p_outside == outside_clamp ? inside_picture(tap_px) : tap_px);
        vec3 v = view_position(tap_px, depth) - position;
        float share = mix(1.0, 2.0 / float(j + 2), p_distance_falloff);
        float raised = cosine + max((dot(v, view) * inversesqrt(max(dot(v, v), 1e-30)) - cosine) * share, 0.0);
        cosine = abs(v.z) < p_thickness ? raised : cosine;
    }
    return clamp(cosine, -1.0, 1.0);
}

float slice_visibility(float azimuth, vec3 position, vec3 normal, vec3 view) {
    vec3 along = vec3(mirrored(vec2(cos(azimuth), sin(azimuth))), 0.0);
    vec3 across = normalize(cross(along, view)), backward = cross(across, view);
    vec3 in_slice = normal - across * dot(normal, across);
    in_slice *= inversesqrt(max(dot(in_slice, in_slice), 1e-12));

    float open = dot(view, cross(in_slice, across));
    float c0 = raised_horizon(open, position, view, p_radius * along);
    float c1 = raised_horizon(-open, position, view, -p_radius * along);
    float sideways = 0.5 * (acos(c1) - acos(c0) + sqrt(1.0 - c0 * c0) * c0 - sqrt(1.0 - c1 * c1) * c1);
    return dot(in_slice, backward) * sideways + dot(in_slice, view) * 0.5 * (2.0 - c0 * c0 - c1 * c1);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = p_normal_source == normal_source_smooth ? centre_normal_smooth() : centre_normal_geometric();
    vec3 view = view_vector(position);
    float turn = p_noise == noise_magic_square ? magic_square_turn() : pixel_noise().x;
    float sum = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        sum += slice_visibility(kTwoPi * turn + kPi * float(i) / float(p_directions), position, normal, view);
    }
    return pow(limited_visibility(sum / float(p_directions)), p_scale);
}
