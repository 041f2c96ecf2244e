#include "contract/inputs.glsl"

// Alchemy's estimator (McGuire et al. 2011): max(0, n·v + z β)/(v·v + ε), z negative. Without ε a tap of the pixel itself
// is 0/0: it obscures nothing.
float alchemy_obscurance(vec3 v, vec3 normal, float z, float beta, float epsilon) {
    float height = max(0.0, dot(v, normal) + z * beta);
    return height > 0.0 ? height / (dot(v, v) + epsilon) : 0.0;
}

// The surface at a tap: on the line of sight through its texel's centre, or through the place itself.
vec3 surface_at(vec2 tap_px, bool through_place) {
    return through_place ? view_position(tap_px, tap_linear_depth(tap_px)) : tap_position(tap_px);
}
