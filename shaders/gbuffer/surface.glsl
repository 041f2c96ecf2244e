// What every pass over the scene's triangles needs of a fragment: its depth, and whether it is there at all. CUTOUT adds
// the alpha test, PEELED leaves what lies behind a layer.
#include "contract/alpha.glsl"
#include "contract/view.glsl"

in vec2 v_texcoord;
#ifdef CUTOUT
in float v_alpha;
uniform float u_alpha_cutoff;
#endif
#ifdef PEELED
uniform sampler2D u_layer_before;  // window depth of the layer in front of this one
#endif

// The far plane's depth marks the background.
float linear_depth() {
#if ORTHOGRAPHIC
    float depth = u_near + gl_FragCoord.z * (u_far - u_near);
#else
    float depth = 1.0 / gl_FragCoord.w;
#endif
    return min(depth, u_far * (1.0 - 2e-7));
}

bool is_passed_over() {
#ifdef PEELED
    if (gl_FragCoord.z <= texelFetch(u_layer_before, ivec2(gl_FragCoord.xy), 0).r) return true;
#endif
#ifdef CUTOUT
    if (alpha_at(v_texcoord, v_alpha) < u_alpha_cutoff) return true;
#endif
    return false;
}
