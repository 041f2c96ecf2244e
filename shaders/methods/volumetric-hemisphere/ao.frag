// Volumetric obscurance of the tangent hemisphere (Loos and Sloan 2010), eq. 2.2.5 of Gravås 2013 corrected.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/line_sample.glsl"
#include "lib/noise.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);
    float open = 0.0, whole = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 tap_px = image_px + radius_px * (turn * k_disc[i].xy);
        LineSample line = line_sample(tap_px, position, normal, p_radius);
        float front = sqrt(max(1.0 - dot(k_disc[i].xy, k_disc[i].xy), 0.0));
        float low = clamp(line.tangent_z, -front, front);
        // A surface at the tangent plane but for rounding is the plane.
        float surface = line.surface_z - line.tangent_z < 1e-4 ? low : line.surface_z;
        open += max(front - max(surface, low), 0.0);
        whole += front - low;
    }
    // No line reaches above the plane: it is seen edge-on, or within a pixel.
    return whole == 0.0 ? 1.0 : limited_visibility(open / whole);
}
