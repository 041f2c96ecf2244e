// Whether a point of view space is hidden behind the depth surface.
#include "contract/inputs.glsl"

// View z of the surface at the point's place in the picture; the point itself must lie before the near plane.
float surface_z_at(vec3 point) { return -tap_linear_depth(image_of(point)); }

bool before_near_plane(vec3 point) { return -point.z < u_near; }

// The surface is nearer than the point by at least `bias` metres.
bool hides(float surface_z, vec3 point, float bias) {
    return surface_z >= point.z + bias && !before_near_plane(point);
}
