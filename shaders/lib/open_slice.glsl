// Bent normal and cone of open arcs in slices through the view vector.
#include "lib/open_cone.glsl"
#include "lib/slice.glsl"

#ifdef OPEN_CONE
vec3 open_sum = vec3(0.0);
float open_weight = 0.0;

// ∫_0^θ |sin t| (sin t, cos t, 1) dt: of directions along the slice, toward the viewer, and their weight, all weighted alike.
vec3 uniform_arc(float angle) {
    float side = sign(angle), sine = sin(angle);
    return vec3(0.5 * abs(angle) - 0.25 * sin(2.0 * abs(angle)), 0.5 * side * sine * sine, side * (1.0 - cos(angle)));
}

// The same with the weight cos(t - γ): the bent normal of Jimenez et al. (2016).
vec3 cosine_arc(float angle, float gamma) {
    float along = 6.0 * sin(angle - gamma) + 8.0 * sin(gamma) - sin(3.0 * angle - gamma) - 3.0 * sin(angle + gamma);
    float toward = 4.0 * cos(gamma) - cos(3.0 * angle - gamma) - 3.0 * cos(angle + gamma);
    return sign(angle) * vec3(along / 12.0, toward / 12.0, slice_arc(angle, gamma));
}

// A difference of two such integrals.
void add_open_arc(vec3 arc, ViewSlice slice) {
    open_sum += arc.x * slice.along + arc.y * slice.view;
    open_weight += arc.z;
}
#endif
