// Hemispherical SSAO (Whinham 2017, B.1): V = 1/N sum of [the surface does not hide the point], points on the shell.
#include "contract/ao_pass.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

// The listing's tangent is what the rotation vector has across the normal, of whatever length.
mat3 tangent_frame(vec3 normal, vec3 rotation_vector) {
    mat3 frame = basis_toward(normal, rotation_vector);
    if (p_tangent == tangent_unit) return frame;
    float stretch = length(cross(normal, mirrored(rotation_vector)));
    return mat3(stretch * frame[0], stretch * frame[1], frame[2]);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 rotation_vector = vec3(pixel_noise().xy * 2.0 - 1.0, 0.0);
    vec3 normal = p_normal_source == normal_source_smooth ? centre_normal_smooth() : centre_normal_geometric();
    mat3 view_from_tangent = tangent_frame(normal, rotation_vector);
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
