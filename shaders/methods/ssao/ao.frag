// Screen-space ambient occlusion (Vermeer 2020, algorithm 1): O = 1/N sum over hidden points of smoothstep(0, 1, R/|P.z -
// z|), z the surface's.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

float visibility(vec2 image_px, vec3 position) {
    float angle = kTwoPi * pixel_noise().x;
    mat3 view_from_tangent = basis_toward(centre_normal_geometric(), vec3(cos(angle), sin(angle), 0.0));
    float occlusion = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + view_from_tangent * k_points[i] * p_radius;
        float surface_z = surface_z_at(point);
        // |difference| kept from 0: the weight is 1 there.
        float weight = smoothstep(0.0, 1.0, p_radius / max(abs(position.z - surface_z), 1e-20));
        occlusion += hides(surface_z, point, p_bias) ? weight : 0.0;
    }
    return 1.0 - occlusion / float(p_samples);
}
