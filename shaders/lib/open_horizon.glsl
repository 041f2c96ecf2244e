// Bent normal and cone of horizons in image directions (Vermeer 2020, section 7.1, algorithm 11): each direction turns the
// normal away from itself by how far the horizon has risen over the tangent; the means over directions are taken.
#include "lib/horizon.glsl"
#include "lib/open_cone.glsl"

#ifdef OPEN_CONE
vec3 turned_sum = vec3(0.0);
float cone_sum = 0.0;

// The axis (0,0,-1) x d turns what looks to the viewer away from d. As printed, d x (0,0,-1), it would turn toward it.
void add_horizon(vec2 direction, vec3 normal, float rise) {
    vec3 axis = cross(vec3(0.0, 0.0, -1.0), view_of_image_direction(direction));
    turned_sum += normal * cos(rise) + cross(axis, normal) * sin(rise) + axis * dot(axis, normal) * (1.0 - cos(rise));
    cone_sum += kHalfPi - rise;
}

void write_horizons(int directions) {
    write_open_cone(turned_sum / float(directions), cone_sum / float(directions));
}
#endif
