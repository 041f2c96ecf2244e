// From a coarser picture to this pass's pixels (Bavoil and Sainz, Multi-Layer Dual-Resolution Screen-Space Ambient
// Occlusion, 2009): the four nearest coarse texels, bilinear weights times nearness in depth.
#include "contract/inputs.glsl"

// The picture's texel that a coarse texel stands for.
ivec2 texel_of_coarser(ivec2 coarse) { return min(coarse * COARSER_SCALE + COARSER_SCALE / 2, ivec2(u_size_px) - 1); }

ivec2 coarser_corner(out vec2 fraction) {
    vec2 at = (vec2(centre_texel()) + 0.5 - float(COARSER_SCALE / 2) - 0.5) / float(COARSER_SCALE);
    // Where a coarse texel lies in the pixel's own row or column, the next one may be that on either side.
    vec2 low = vec2(MIRROR_X < 0 ? ceil(at.x) - 1.0 : floor(at.x), MIRROR_Y < 0 ? ceil(at.y) - 1.0 : floor(at.y));
    fraction = at - low;
    return ivec2(low);
}

ivec2 inside_coarser(ivec2 coarse) { return clamp(coarse, ivec2(0), textureSize(u_coarser, 0) - 1); }

// Weight 1 within a pixel's slope or so of the centre's depth, falling as the square beyond.
float upsampled_visibility() {
    vec2 fraction;
    ivec2 corner = coarser_corner(fraction);
    float depth = centre_linear_depth();
    float scale = 0.02 * depth;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 side = ivec2(i & 1, i >> 1);
        ivec2 coarse = inside_coarser(corner + side);
        vec2 bilinear = mix(1.0 - fraction, fraction, vec2(side));
        float difference = (texelFetch(u_linear_depth, texel_of_coarser(coarse), 0).r - depth) / scale;
        float weight = (bilinear.x * bilinear.y + 1e-3) / (1e-4 + difference * difference);
        sum += weight * texelFetch(u_coarser, coarse, 0).r;
        weights += weight;
    }
    return sum / weights;
}

// Largest less smallest value among the 3x3 coarse texels around: where it is large, coarse is not enough.
const float kDualThreshold = 0.1;
float coarser_range() {
    ivec2 middle = inside_coarser(centre_texel() / COARSER_SCALE);
    float low = 1.0, high = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            float v = texelFetch(u_coarser, inside_coarser(middle + ivec2(x, y)), 0).r;
            low = min(low, v);
            high = max(high, v);
        }
    }
    return high - low;
}
