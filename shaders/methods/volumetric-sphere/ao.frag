// Volumetric obscurance of the surrounding sphere (Loos and Sloan 2010). With z toward the viewer and P at the origin, a
// line at (x, y) is open from the surface d_s to the sphere's front d_r = √(1 - x² - y²): max(d_r - max(d_s, -d_r), 0).
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/line_sample.glsl"
#include "lib/noise.glsl"

float visibility(vec2 image_px, vec3 position) {
    float radius_px = p_radius * pixels_per_metre(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);
    float open = 0.0, whole = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec2 tap_px = image_px + radius_px * (turn * k_disc[i].xy);
        LineSample line = line_sample(tap_px, position, vec3(0.0, 0.0, 1.0), p_radius);
        float front = sqrt(max(1.0 - dot(k_disc[i].xy, k_disc[i].xy), 0.0));
        open += max(front - max(line.surface_z, -front), 0.0);
        whole += front;
    }
    if (whole == 0.0) return 1.0;  // less than a pixel: nothing is seen beside the surface
    return limited_visibility(open / (p_normalise == normalise_plane ? whole : 2.0 * whole));
}
