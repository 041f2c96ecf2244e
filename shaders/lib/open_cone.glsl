// What is open about a pixel as a mean direction and a cone, for methods that give the signals bent_normal and cone_angle.
// OPEN_CONE is defined where one of them is asked for: all that serves them stands between #ifdef OPEN_CONE and #endif.
#include "lib/constants.glsl"

#if defined(SIGNAL_BENT_NORMAL) || defined(SIGNAL_CONE_ANGLE)
#define OPEN_CONE

// The mean open direction in view space, of any length, and the cone's half angle about it.
void write_open_cone(vec3 bent_normal, float half_angle) {
#ifdef SIGNAL_BENT_NORMAL
    o_bent_normal = bent_normal;
#endif
#ifdef SIGNAL_CONE_ANGLE
    o_cone_angle = half_angle;
#endif
}

// Of a mean of unit directions, all directions weighted alike: π/2 for the hemisphere's, which is 1/2 long (Klehm et al.,
// Screen-Space Bent Cones: A Practical Approach, 2012; Vermeer 2020, section 7.1).
float cone_of_length(float size) { return kHalfPi * (1.0 - clamp(2.0 * size - 1.0, 0.0, 1.0)); }

// A weighted sum of directions. Where nothing is open, the normal and a closed cone.
void write_mean_direction(vec3 sum, float weight, vec3 normal) {
    vec3 bent_normal = weight > 0.0 ? sum / weight : normal;
    write_open_cone(bent_normal, cone_of_length(length(bent_normal)));
}
#endif
