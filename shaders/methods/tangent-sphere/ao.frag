// Volumetric ambient occlusion of the tangent sphere (Szirmay-Kalos et al. 2010). The sphere's lengths along directions ω
// from P are R n·ω: the cosine weight is in its shape. With z toward the viewer and the sphere's centre at the origin, a
// line at (x, y) is open from the surface to d_r: V = sum min(max(d_r - d_s, 0), 2 d_r) / sum 2 d_r.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float radius = 0.5 * p_radius;
    vec3 centre = position + normal * radius;
    mat2 turn = rotation(kTwoPi * pixel_noise().x);
    float open = 0.0, whole = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 offset = turn * k_disc[i].xy;
        vec3 line = centre + vec3(radius * offset, 0.0);
        float surface = (-tap_linear_depth(image_of(line)) - centre.z) / radius;
        float front = sqrt(max(1.0 - dot(k_disc[i].xy, k_disc[i].xy), 0.0));  // turning keeps it
        bool seen = -line.z >= u_near;
        open += seen ? clamp(front - surface, 0.0, 2.0 * front) : 2.0 * front;
        whole += 2.0 * front;
    }
    return whole == 0.0 ? 1.0 : open / whole;
}
