// Hemispherical SSAO (Whinham 2017, B.1): V = 1/N sum of [the surface does not hide the point], points on the shell.
#include "contract/ao_pass.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec3 rotation_vector = vec3(pixel_noise().xy * 2.0 - 1.0, 0.0);
    mat3 view_from_tangent = basis_toward(centre_normal_geometric(), rotation_vector);
    float occlusion = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + view_from_tangent * k_points[i] * p_radius;
        float surface_z = surface_z_at(point);
        bool in_range = !p_range_check || abs(position.z - surface_z) < p_radius;
        occlusion += hides(surface_z, point, p_bias) && in_range ? 1.0 : 0.0;
    }
    return 1.0 - occlusion / float(p_samples);
}
