// Screen-space ambient occlusion by point tests in a sphere (Mittring 2007, Kajalin 2009; Hussain 2022, eq. 4 and 5).
// V = 1/N sum v(S), v = 0 where the depth surface lies in front of the sample S by `bias` and within the range check.
// Half of the sphere is below a plane: it reads about one half.
#include "contract/ao_pass.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/point_test.glsl"

// The sphere is symmetric, the kernel is not: reflecting it by a plane of its own gives each pixel other points.
vec3 reflecting_plane(vec3 random_vector) {
    vec3 plane = random_vector - 1.0;
    return p_plane == plane_unit ? normalize(plane) : plane;
}

// How much the surface at `surface_z` may say about a point: 1 within the range.
float validity(float surface_z, float position_z) {
    float nearer = surface_z - position_z;
    if (p_range_check == range_check_absolute) return abs(nearer) < p_radius ? 1.0 : 0.0;
    if (p_range_check == range_check_as_printed) return -nearer < p_radius ? 1.0 : 0.0;
    if (p_range_check == range_check_fade) return 1.0 - clamp(nearer / -surface_z, 0.0, 1.0);
    return 1.0;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 random_vector = vec3(pixel_noise().xy * 2.0 - 1.0, 0.0);
    vec3 normal = p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
    mat3 view_from_tangent = basis_toward(normal, random_vector);
    vec3 plane = reflecting_plane(random_vector);
    // An invalid surface leaves the point open, or half open where the fade is Kajalin's.
    float unknown = p_range_check == range_check_fade ? 0.5 : 0.0;

    float occlusion = 0.0;
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        vec3 point = position + view_from_tangent * reflect(k_points[i], plane) * p_radius;
        float surface_z = surface_z_at(point);
        occlusion += mix(unknown, hides(surface_z, point, p_bias) ? 1.0 : 0.0, validity(surface_z, position.z));
    }
    return 1.0 - occlusion / float(p_samples);
}
