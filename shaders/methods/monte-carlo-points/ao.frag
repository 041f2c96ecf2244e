// Monte-Carlo integration by point tests (Ritschel, Grosch and Seidel 2009; Gravås 2013, section 2.2.2.1 corrected).
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

float visibility(vec2 image_px, vec3 position) {
    float angle = kTwoPi * pixel_noise().x;
    mat3 view_from_tangent = basis_toward(centre_normal_geometric(), vec3(cos(angle), sin(angle), 0.0));
    float occlusion = 0.0, cosines = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 offset = k_points[i];
        float distance_squared = dot(offset, offset);
        float cosine = distance_squared > 0.0 ? offset.z * inversesqrt(distance_squared) : 0.0;
        vec3 point = position + view_from_tangent * offset * p_radius;
        float surface_z = surface_z_at(point);
        bool in_range = !p_range_check || abs(position.z - surface_z) < p_radius;
        float weight = p_falloff == falloff_quadratic ? 1.0 - distance_squared : 1.0;
        occlusion += hides(surface_z, point, p_bias) && in_range ? weight * cosine : 0.0;
        cosines += cosine;
    }
    return 1.0 - occlusion / cosines;
}
