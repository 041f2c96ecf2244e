// Randomness may be mirrored, so that a test can ask for the mirrored picture of a mirrored scene: MIRROR_X -1 changes
// left and right, MIRROR_Y -1 above and below; else 1. Whatever chooses places and directions goes through here, mostly by
// way of lib/: the noise's texel, rotations of kernels, slices, frames. What is read of the scene does not.
#ifndef MIRROR_X
#define MIRROR_X 1
#endif
#ifndef MIRROR_Y
#define MIRROR_Y 1
#endif
const vec2 kMirror = vec2(MIRROR_X, MIRROR_Y);
const float kHandedness = float(MIRROR_X * MIRROR_Y);  // of frames: the mirror turns the third axis over

// Of the picture plane, or view space: their axes are parallel.
vec2 mirrored(vec2 direction) { return kMirror * direction; }
vec3 mirrored(vec3 direction) { return vec3(kMirror * direction.xy, direction.z); }

// Where this texel of a picture was before.
ivec2 mirrored_texel(ivec2 texel, ivec2 size) {
    ivec2 other = size - 1 - texel;
    return ivec2(MIRROR_X < 0 ? other.x : texel.x, MIRROR_Y < 0 ? other.y : texel.y);
}
