// Sphere caps (Shanmugam and Arikan 2007). A sphere of radius r at distance d covers the solid angle 2π (1 - cos(asin(r/d)))
// = 2π (1 - √(1 - (r/d)²)).
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    float radius_px = p_radius * pixels_per_metre(-position.z);
    mat2 turn = rotation(kTwoPi * pixel_noise().x);
    float sum = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 tap = tap_position(image_px + radius_px * (turn * k_disc[i].xy));
        vec3 v = tap - position;
        float distance_squared = dot(v, v);
        float inverse_distance = inversesqrt(max(distance_squared, 1e-30));
        float sine = p_sphere_px * pixel_footprint(-tap.z) * inverse_distance;
        float cap = kTwoPi * (1.0 - sqrt(max(1.0 - sine * sine, 0.0)));
        bool counts = sine < 1.0 && distance_squared < p_radius * p_radius;
        sum += counts ? cap * max(dot(v, normal) * inverse_distance, 0.0) : 0.0;
    }
    float pixels_a_tap = kPi * radius_px * radius_px / float(p_samples);
    return limited_visibility(1.0 - sum * pixels_a_tap / kPi);
}
