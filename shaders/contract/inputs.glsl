// What a pass may read. The descriptor lists the inputs; each is the sampler u_<input>. Fetches at the shaded pixel
// itself are the centre's; every other one is a tap, and an instrumented build counts the taps (all of depth, normal
// and other G-buffer texels; noise and the centre are not counted).
#include "contract/view.glsl"

uniform sampler2D u_linear_depth;      // metres, positive; u_far on background
uniform sampler2D u_hardware_depth;    // window depth in [0,1]
uniform sampler2D u_normal_geometric;  // view space, unit, turned to the camera
uniform sampler2D u_normal_smooth;     // the same, interpolated
uniform sampler2D u_albedo;            // linear RGB
uniform sampler2D u_noise_4x4;         // four numbers in [0,1) a texel, each a permutation of (i + ½)/16
uniform uint u_seed;                   // of the run

#if COUNT_FETCHES
float tap_count = 0.0;
#define COUNT_TAP tap_count += 1.0;
#else
#define COUNT_TAP
#endif

ivec2 centre_texel() { return ivec2(gl_FragCoord.xy); }
float centre_linear_depth() { return texelFetch(u_linear_depth, centre_texel(), 0).r; }
vec3 centre_normal_geometric() { return texelFetch(u_normal_geometric, centre_texel(), 0).xyz; }
vec3 centre_normal_smooth() { return texelFetch(u_normal_smooth, centre_texel(), 0).xyz; }
vec4 tiled_noise() { return texelFetch(u_noise_4x4, centre_texel() & 3, 0); }

bool in_picture(vec2 image_px) {
    return all(greaterThanEqual(image_px, vec2(0.0))) && all(lessThan(image_px, u_size_px));
}

// The texel that an image position falls into; outside of the picture the nearest one (clamp to edge).
ivec2 texel_at(vec2 image_px) { return ivec2(clamp(image_px, vec2(0.5), u_size_px - 0.5)); }
vec2 texel_centre(ivec2 texel) { return vec2(texel) + 0.5; }

// Taps.
float tap_linear_depth(ivec2 texel) {
    COUNT_TAP
    return texelFetch(u_linear_depth, texel, 0).r;
}

// View-space position of the surface in the texel at an image position. It lies on the line of sight through the
// texel's centre, so that a plane in the scene gives points on that plane.
vec3 tap_position(vec2 image_px) {
    ivec2 texel = texel_at(image_px);
    return view_position(texel_centre(texel), tap_linear_depth(texel));
}
