// Depth layers from the surfaces that peeled_surfaces.frag has left of a scene: the coins are those of depth_layers.frag,
// and so are the samples. Draws the four of one picture.
#include "contract/view.glsl"
#include "coins.glsl"

uniform sampler2DArray u_surface_depths;      // front to back, metres, negative seen from behind; u_far where there is none
uniform usampler2DArray u_surface_triangles;
uniform int u_surfaces;
uniform int u_picture;
uniform float u_least_gap;  // metres

layout(location = 0) out vec4 o_depths;

uint surface_triangle = 0u;
uint triangle_id() { return surface_triangle; }

void main() {
    vec4 depths = vec4(u_far);
    float before = 0.0;
    int layers = 0;
    for (int i = 0; i < u_surfaces; ++i) {
        ivec3 place = ivec3(ivec2(gl_FragCoord.xy), i);
        float turned = texelFetch(u_surface_depths, place, 0).r, depth = abs(turned);
        if (is_background(depth)) break;
#if defined(SAMPLING_PEELED)
        if (layers > 0 && depth < before + u_least_gap) continue;
#ifdef FACING
        depth = turned;
#endif
        if (layers / 4 == u_picture) depths[layers % 4] = depth;
        before = abs(turned);
        ++layers;
#else
        surface_triangle = texelFetch(u_surface_triangles, place, 0).r;
        bvec4 accepted[kOutputs] = accepted_samples();
        depths = mix(depths, min(depths, vec4(depth)), accepted[u_picture]);
#endif
    }
    o_depths = depths;
}
