// Screen-space ambient occlusion (Vermeer 2020, algorithm 1; de Vries, LearnOpenGL): O = 1/N sum over hidden points of
// smoothstep(0, 1, R/|P.z - z|), z the surface's.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/open_cone.glsl"
#include "lib/point_test.glsl"

vec3 shading_normal() {
    if (p_normal_source == normal_source_smooth) return centre_normal_smooth();
    return p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
}

// What the tangent is turned toward: an even angle, or a point of the square, whose diagonals are likelier.
vec3 random_direction() {
    vec4 noise = pixel_noise();
    float angle = kTwoPi * noise.x;
    return p_rotation == rotation_square ? vec3(2.0 * noise.xy - 1.0, 0.0) : vec3(cos(angle), sin(angle), 0.0);
}

// View z of the surface at the point's place, at the picture's edge where that is outside and `outside` is clamp.
float surface_z(vec3 point) {
    vec2 tap_px = image_of(point);
    return -tap_linear_depth(p_outside == outside_clamp ? inside_picture(tap_px) : tap_px);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = shading_normal();
    mat3 view_from_tangent = basis_toward(normal, random_direction());
    float occlusion = 0.0;
#ifdef OPEN_CONE
    vec3 open_sum = vec3(0.0);
#endif
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + view_from_tangent * k_points[i] * p_radius;
        float z = surface_z(point);
        // |difference| kept from 0: the weight is 1 there.
        float weight = smoothstep(0.0, 1.0, p_radius / max(abs(position.z - z), 1e-20));
        float hidden = hides(z, point, p_bias) ? weight : 0.0;
        occlusion += hidden;
#ifdef OPEN_CONE
        open_sum += (1.0 - hidden) * normalize(view_from_tangent * k_points[i]);
#endif
    }
#ifdef OPEN_CONE
    write_mean_direction(open_sum, float(p_samples) - occlusion, normal);
#endif
    return 1.0 - occlusion / float(p_samples);
}
