// Line samples: the line of sight through a tap's texel, and where it meets the depth surface and the tangent plane.
#include "contract/inputs.glsl"

struct LineSample {
    float surface_z;  // of the depth surface, from P toward the viewer, in units of the radius
    float tangent_z;  // of the tangent plane, the same
};

LineSample line_sample(vec2 tap_px, vec3 position, vec3 normal, float radius) {
    vec2 centre_px = floor(tap_px) + 0.5;
    LineSample line;
    line.surface_z = (-tap_linear_depth(tap_px) - position.z) / radius;
    // Where the line of sight origin + t ray meets the plane through P.
    vec3 ray = view_ray(centre_px);
    vec3 origin = view_position(centre_px, 0.0);
    float facing = dot(ray, normal);
    float depth = dot(position - origin, normal) / (abs(facing) > 1e-6 ? facing : -1e-6);
    line.tangent_z = clamp((-depth - position.z) / radius, -1e6, 1e6);
    return line;
}
