// Deferred lighting: ambient light times visibility, and coloured point lights by Phong's model (Phong, Illumination for
// computer generated pictures, 1975). Every pixel is written; the background is black.
#include "contract/inputs.glsl"
#include "lib/constants.glsl"

uniform sampler2D u_visibility;  // after its filter

layout(location = 0) out vec4 o_radiance;  // linear RGB

// On a circle about the line of sight, in front of the camera.
vec3 light_position(float turn) {
    return vec3(p_ring * cos(kTwoPi * turn), p_ring * sin(kTwoPi * turn), -p_ahead);
}

// Hues around the circle, mixed with white.
vec3 light_colour(float turn) {
    vec3 hue = clamp(abs(fract(turn + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return p_intensity * mix(vec3(1.0), hue, p_saturation);
}

void main() {
    float depth = centre_linear_depth();
    vec2 image_px = texel_centre(centre_texel());
    vec3 position = view_position(image_px, depth), normal = centre_normal_geometric();
    vec3 albedo = picture_texel(u_albedo, vec2(centre_texel())).rgb;
    float visibility = min(picture_texel(u_visibility, vec2(centre_texel())).r, 1.0);  // a method may overshoot
    vec3 radiance = p_ambient * visibility * albedo;
    vec3 to_viewer = -normalize(view_ray(image_px));
#pragma unroll
    for (int i = 0; i < p_lights; ++i) {
        float turn = (float(i) + 0.5) / float(p_lights);
        vec3 offset = light_position(turn) - position;
        float distance_squared = max(dot(offset, offset), 1e-30);
        vec3 to_light = offset * inversesqrt(distance_squared);
        float diffuse = max(dot(normal, to_light), 0.0);
        float mirrored_light = max(dot(reflect(-to_light, normal), to_viewer), 0.0);
        float specular = diffuse > 0.0 ? p_specular * pow(mirrored_light, p_shininess) : 0.0;
        radiance += light_colour(turn) * (albedo * diffuse + specular) / (1.0 + distance_squared / (p_reach * p_reach));
    }
    o_radiance = is_background(depth) ? vec4(0.0) : vec4(radiance, 1.0);
}
