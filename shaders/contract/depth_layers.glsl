// Several depths a texel, in no order: stochastic-depth samples, or peeled layers from front to back. The descriptor's
// "depth_layers" says how they are gathered; the number of samples must be its parameter depth_samples.
#include "contract/inputs.glsl"

uniform sampler2DArray u_depth_layers;  // four samples a texel of each picture

// How many pictures they fill, and the four depths of one: the far plane's where there is no sample. Each is a fetch. What
// lies outside of the picture is as for other taps; in a G-buffer of half the resolution, those of the texel that it holds.
int depth_pictures() { return (p_depth_samples + 3) / 4; }

vec4 tap_depths(vec2 image_px, int picture) {
    COUNT_TAP
    vec2 texel = tapped_texel(image_px), inside = clamp(texel, vec2(0.0), u_size_px - 1.0);
    vec4 depths = texelFetch(u_depth_layers, ivec3(inside, picture), 0);
#if BORDER_FAR
    depths = texel == inside ? depths : vec4(u_far);
#endif
    return mix(vec4(u_far), depths, lessThan(ivec4(0, 1, 2, 3) + 4 * picture, ivec4(p_depth_samples)));
}

// The point of a depth in that texel.
vec3 layer_position(vec2 image_px, float depth) { return view_position(tapped_texel(image_px) + 0.5, depth); }
