// Brute force over one depth layer: V = mean over cosine-distributed rays of [no step lies behind the depth surface].
// A tap hides a point that it is nearer to the eye than and higher above the tangent plane than: a plane cannot hide itself
// where a tap is read at its texel's centre, and where a plane is seen almost edge-on, what a texel's height tells of a far
// surface cannot hide a near point. A line of sight that runs away from the plane, to a point higher above it than the
// eye, never meets it: there depth alone decides. The line is the tap's, through its texel's centre.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"

bool hit(vec3 point, vec3 position, vec3 normal, float step_length) {
    vec3 tap = tap_position(image_of(point));
    bool toward_plane = dot(view_ray(image_of(tap)), normal) < 0.0;
    bool behind = tap.z > point.z && (!toward_plane || dot(tap - point, normal) > 0.0);
    return behind && -point.z >= u_near &&
           (p_occluders == occluders_solid || tap.z - point.z < p_thickness + step_length);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec4 noise = pixel_noise();
    float angle = kTwoPi * noise.x;
    mat3 view_from_tangent = basis_toward(normal, vec3(cos(angle), sin(angle), 0.0));
    float step_length = p_radius / float(p_steps);
    float open = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec3 step_vector = view_from_tangent * k_rays[i] * step_length;
        float shift = fract(noise.y + float(i) * 0.61803399);
        bool hidden = false;
#pragma unroll
        for (int j = 0; j < p_steps; ++j) {
            hidden = hit(position + step_vector * (float(j) + shift), position, normal, step_length) || hidden;
        }
        open += hidden ? 0.0 : 1.0;
    }
    return open / float(p_directions);
}
