// Screen-space ambient occlusion (Vermeer 2020, algorithm 1; de Vries, LearnOpenGL): O = 1/N sum over hidden points of
// smoothstep(0, 1, R/|P.z - z|), z the surface's. The method says how the points are turned and what hides one.
#include "contract/inputs.glsl"
#include "lib/open_cone.glsl"
#include "lib/frame.glsl"
#include "lib/point_test.glsl"

vec3 shading_normal();
// What the tangent is turned toward.
vec3 random_direction();
// How far this point is hidden from the pixel's: 0 to 1.
float hidden_part(vec3 point, vec3 position);

// By a surface at this view z.
float hidden_by(float z, vec3 point, vec3 position) {
    // |difference| kept from 0: the weight is 1 there.
    float weight = smoothstep(0.0, 1.0, p_radius / max(abs(position.z - z), 1e-20));
    bool hidden = !is_background(-z) && hides(z, point, p_bias);  // also from a point beyond the far plane
    return hidden ? weight : 0.0;
}

// The sum over all points.
float hidden_points(vec3 position) {
    vec3 normal = shading_normal();
    mat3 view_from_tangent = basis_toward(normal, random_direction());
    float occlusion = 0.0;
#ifdef OPEN_CONE
    vec3 open_sum = vec3(0.0);
#endif
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + view_from_tangent * k_points[i] * p_radius;
        float hidden = hidden_part(point, position);
        occlusion += hidden;
#ifdef OPEN_CONE
        open_sum += (1.0 - hidden) * normalize(view_from_tangent * k_points[i]);
#endif
    }
#ifdef OPEN_CONE
    write_mean_direction(open_sum, float(p_samples) - occlusion, normal);
#endif
    return occlusion;
}
