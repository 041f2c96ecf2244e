// The shaded pixel's normal as the method's choice parameter `normal_source` says: from_depth, or else the triangle's.
#include "contract/inputs.glsl"

vec3 shading_normal() {
    return p_normal_source == normal_source_from_depth ? centre_normal_from_depth() : centre_normal_geometric();
}
