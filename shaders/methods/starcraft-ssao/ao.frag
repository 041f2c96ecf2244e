// StarCraft II's ambient occlusion (Filion and McNaughton 2008; Gravås 2013, eq. 2.2.3 corrected).
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

// Uniform random directions: a plane's normal in each pixel mirrors the whole kernel.
vec3 mirror_normal(vec4 noise) {
    float z = 1.0 - 2.0 * noise.x;
    float angle = kTwoPi * noise.y;
    return vec3(sqrt(1.0 - z * z) * vec2(cos(angle), sin(angle)), z);
}

vec3 into_hemisphere(vec3 offset, vec3 normal) {
    float height = dot(offset, normal);
    if (p_turn == turn_negate) return height < 0.0 ? -offset : offset;
    return height < 0.0 ? offset - 2.0 * height * normal : offset;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 mirror = mirror_normal(pixel_noise());
    float occlusion = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + into_hemisphere(mirrored(reflect(k_points[i], mirror)), normal) * p_radius;
        float surface_z = surface_z_at(point);
        float invalid = clamp((position.z - surface_z) / surface_z, 0.0, 1.0);
        occlusion += hides(surface_z, point, p_bias) ? 1.0 - invalid : 0.0;
    }
    return 1.0 - occlusion / float(p_samples);
}
