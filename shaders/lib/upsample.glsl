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

// Depth, or in perspective its inverse: linear over the picture of a plane. A change of it, times this, is in metres.
#if ORTHOGRAPHIC
float plane_linear(float depth) { return depth; }
float metres_of_change(float depth) { return 1.0; }
#else
float plane_linear(float depth) { return 1.0 / depth; }
float metres_of_change(float depth) { return depth * depth; }
#endif

float plane_linear_at(ivec2 texel) { return plane_linear(texelFetch(u_linear_depth, texel, 0).r); }

// Its change a pixel along an axis: the smaller of both sides', since that is on the same surface.
float change_along(ivec2 axis, float here) {
    ivec2 last = ivec2(u_size_px) - 1, ahead = min(centre_texel() + axis, last), back = max(centre_texel() - axis, 0);
    float forward = plane_linear_at(ahead) - here, backward = here - plane_linear_at(back);
    bool has_ahead = ahead != centre_texel(), has_back = back != centre_texel();
    return !has_back || (has_ahead && abs(forward) < abs(backward)) ? forward : backward;
}

// Nearness is to the plane that the surface makes here, however steep, in pixels of the coarse picture.
float upsampled_visibility() {
    vec2 fraction;
    ivec2 corner = coarser_corner(fraction);
    float depth = centre_linear_depth();
    float here = plane_linear(depth);
    vec2 change = vec2(change_along(ivec2(1, 0), here), change_along(ivec2(0, 1), here));
    float scale = metres_of_change(depth) / (pixel_footprint(depth) * float(COARSER_SCALE));
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 side = ivec2(i & 1, i >> 1);
        ivec2 coarse = inside_coarser(corner + side);
        ivec2 texel = texel_of_coarser(coarse);
        vec2 bilinear = mix(1.0 - fraction, fraction, vec2(side));
        float on_plane = here + dot(change, vec2(texel - centre_texel()));
        float difference = (plane_linear_at(texel) - on_plane) * scale;
        float weight = (bilinear.x * bilinear.y + 1e-3) / (0.1 + difference * difference);
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
