// SSAO over the depth surface (lib/ssao.glsl).
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/noise.glsl"
#include "lib/ssao.glsl"

vec3 shading_normal() {
    if (p_normal_source == normal_source_smooth) return centre_normal_smooth();
    return p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
}

// An even angle, or a point of the square, whose diagonals are likelier.
vec3 random_direction() {
    vec4 noise = pixel_noise();
    float angle = kTwoPi * noise.x;
    return p_rotation == rotation_square ? vec3(2.0 * noise.xy - 1.0, 0.0) : vec3(cos(angle), sin(angle), 0.0);
}

// View z of the surface at the point's place, at the picture's edge where that is outside and `outside` is clamp.
float surface_z(vec3 point) {
    vec2 tap_px = image_of(point);
    return -tap_linear_depth(p_outside == outside_clamp ? inside_picture(tap_px) : tap_px);
}

float hidden_part(vec3 point, vec3 position) { return hidden_by(surface_z(point), point, position); }

float visibility(vec2 image_px, vec3 position) { return 1.0 - hidden_points(position) / float(p_samples); }
