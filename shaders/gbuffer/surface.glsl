// What every pass over the scene's triangles needs of a fragment: its depth, and whether it is there at all. CUTOUT adds
// the alpha test, PEELED leaves what lies behind a layer, LEAST_GAP what lies so far behind it.
#include "contract/alpha.glsl"
#include "contract/view.glsl"

in vec2 v_texcoord;
#ifdef CUTOUT
in float v_alpha;
uniform float u_alpha_cutoff;
#endif
#ifdef PEELED
uniform sampler2D u_layer_before;  // window depth of the layer in front of this one
#ifdef LEAST_GAP
uniform float u_least_gap;  // metres
#endif
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

#if defined(PEELED) && defined(LEAST_GAP)
float depth_of_window(float window) {
#if ORTHOGRAPHIC
    return u_near + window * (u_far - u_near);
#else
    return 1.0 / mix(1.0 / u_near, 1.0 / u_far, window);
#endif
}
#endif

bool is_passed_over() {
#ifdef PEELED
    float before = texelFetch(u_layer_before, ivec2(gl_FragCoord.xy), 0).r;
    if (gl_FragCoord.z <= before) return true;
#ifdef LEAST_GAP
    if (linear_depth() < depth_of_window(before) + u_least_gap) return true;
#endif
#endif
#ifdef CUTOUT
    if (alpha_at(v_texcoord, v_alpha) < u_alpha_cutoff) return true;
#endif
    return false;
}
