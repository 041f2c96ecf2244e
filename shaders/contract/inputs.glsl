// What a pass may read. The descriptor lists the inputs; each is the sampler u_<input>. Fetches at the shaded pixel
// itself are the centre's; every other one is a tap, and an instrumented build counts the taps (all of depth, normal
// and other G-buffer texels; noise and the centre are not counted).
#include "contract/mirror.glsl"
#include "contract/view.glsl"

uniform uint u_seed;  // of the run

#if COUNT_FETCHES
float tap_count = 0.0;
#define COUNT_TAP tap_count += 1.0;
#else
#define COUNT_TAP
#endif

// The value of a texel of the picture's size. A sampler that takes the nearest texel and clamps to the edge costs less
// here than texelFetch, which checks level and bounds; the texel's centre is far from where rounding could tell.
vec4 picture_texel(sampler2D picture, vec2 texel) { return textureLod(picture, (texel + 0.5) / u_size_px, 0.0); }

// The texel that is drawn, and the picture's texel that it stands for: the same, unless the pass is drawn at 1/SCALE.
ivec2 drawn_texel() { return ivec2(gl_FragCoord.xy); }
vec2 texel_centre(ivec2 texel) { return vec2(texel) + 0.5; }
ivec2 centre_texel() { return min(drawn_texel() * SCALE + SCALE / 2, ivec2(u_size_px) - 1); }

#include "contract/channels.glsl"  // generated from the tables of src/image/channels.cpp

// The texel whose noise is this one's.
ivec2 noise_texel() { return mirrored_texel(drawn_texel(), (ivec2(u_size_px) + SCALE - 1) / SCALE); }
vec4 tiled_noise() { return texelFetch(u_noise_4x4, noise_texel() & 3, 0); }

// The picture's texel that a tap reads. Texels as floats: they are needed as such, and outside of the picture they need
// not fit an integer. A G-buffer of half the resolution holds one texel of each block of 2x2, that on the lower right;
// the last block of an odd size has none there.
#if HALF_TAPS
uniform sampler2D u_half_depth;  // metres
vec2 tapped_texel(vec2 image_px) {
    vec2 texel = 2.0 * floor(0.5 * image_px) + 1.0;
    return texel - vec2(equal(texel, u_size_px));
}
float depth_of_tapped(vec2 texel) {
    return textureLod(u_half_depth, (floor(0.5 * texel) + 0.5) / ceil(0.5 * u_size_px), 0.0).r;
}
#else
vec2 tapped_texel(vec2 image_px) { return floor(image_px); }
float depth_of_tapped(vec2 texel) { return picture_texel(u_linear_depth, texel).r; }
#endif

// Where a run stores positions in place of depth, they lie in the same texture: depth, then x and y.
#ifdef STORED_POSITIONS
vec3 stored_position(vec2 texel) {
    vec3 stored = picture_texel(u_linear_depth, texel).rgb;
    return vec3(stored.gb, -stored.r);
}
#endif

// Taps. What lies outside of the picture is a setting of the run: BORDER_FAR 1, the depth of the background; 0, the
// depth of the nearest texel (clamp to edge), which stretches the picture's edge outward.
float texel_linear_depth(vec2 texel) {
    COUNT_TAP
    float depth = depth_of_tapped(texel);
#if BORDER_FAR
    return texel == clamp(texel, vec2(0.0), u_size_px - 1.0) ? depth : u_far;
#else
    return depth;
#endif
}

float tap_linear_depth(vec2 image_px) { return texel_linear_depth(tapped_texel(image_px)); }

// View-space position of the surface in the texel at an image position. It lies on the line of sight through the
// texel's centre, so that a plane in the scene gives points on that plane.
vec3 tap_position(vec2 image_px) {
    vec2 texel = tapped_texel(image_px);
#ifdef STORED_POSITIONS
    if (texel == clamp(texel, vec2(0.0), u_size_px - 1.0)) {
        COUNT_TAP
        return stored_position(texel);
    }
#endif
    return view_position(texel + 0.5, texel_linear_depth(texel));
}

// Level `mip` of the depth mips: the depth of a larger texel, and its point on the line of sight through the full
// picture's texel.
const int kDepthMipLevels = 6;
float tap_mip_depth(vec2 image_px, int mip) {
#if HALF_TAPS
    if (mip == 0) return tap_linear_depth(image_px);  // the full picture is not to be read
#endif
    COUNT_TAP
    vec2 texel = floor(image_px), inside = clamp(texel, vec2(0.0), u_size_px - 1.0);
    // Not textureSize: where pixels differ in `mip`, llvmpipe gives them all the size of one pixel's level.
    float depth = texelFetch(u_depth_mips, min(ivec2(inside) >> mip, max(ivec2(u_size_px) >> mip, 1) - 1), mip).r;
#if BORDER_FAR
    depth = inside == texel ? depth : u_far;
#endif
    return depth;
}

vec3 tap_mip_position(vec2 image_px, int mip) {
    float depth = tap_mip_depth(image_px, mip);
#if HALF_TAPS
    if (mip == 0) return view_position(tapped_texel(image_px) + 0.5, depth);
#endif
    return view_position(floor(image_px) + 0.5, depth);
}

// The nearest place whose texel exists: for methods that clamp to the edge whatever the run's border is.
vec2 inside_picture(vec2 image_px) { return clamp(image_px, vec2(0.5), u_size_px - 0.5); }
