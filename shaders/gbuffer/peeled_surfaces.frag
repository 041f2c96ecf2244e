// One layer of the surfaces behind one another, from which gathered_layers.frag makes depth layers without the scene:
// depth, negative where a face is seen from behind, and the triangle, in two halves that a float holds exactly.
#include "surface.glsl"
#include "facing.glsl"
#include "triangle_id.glsl"

layout(location = 0) out vec4 o_surface;

void main() {
    if (is_passed_over()) discard;
    float depth = linear_depth();
    uint triangle = triangle_id();
    o_surface = vec4(is_front() ? depth : -depth, float(int(triangle & 65535u)), float(int(triangle >> 16u)), 0.0);
}
