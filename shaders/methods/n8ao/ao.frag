// N8AO: V = (1/N sum of [open])^intensity over cosine-distributed directions, each tested at one point whose distance is
// stratified over the kernel and shifted in every pixel.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec4 noise = pixel_noise();
    float angle = kTwoPi * noise.x;
    mat3 view_from_tangent = basis_toward(centre_normal_geometric(), vec3(cos(angle), sin(angle), 0.0));
    float occlusion = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        // Golden-ratio steps keep the distances apart from the directions, which come in another sequence.
        float part = fract((float(i) + 0.5) * 0.61803399 + noise.y);
        vec3 point = position + view_from_tangent * k_directions[i] * (part * p_radius);
        float surface_z = surface_z_at(point);
        float weight = smoothstep(0.0, 1.0, p_falloff * p_radius / max(abs(position.z - surface_z), 1e-20));
        occlusion += hides(surface_z, point, p_bias * p_radius) ? weight : 0.0;
    }
    float open = limited_visibility(1.0 - occlusion / float(p_samples));
    return p_intensity == 1.0 ? open : pow(open, p_intensity);
}
