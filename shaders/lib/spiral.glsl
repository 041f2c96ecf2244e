// Taps on a spiral (McGuire, Mara and Luebke, Scalable Ambient Obscurance, 2012).
#include "contract/mirror.glsl"

// The i-th of `count` taps: angle and part of the radius, α = (i + ½)/count.
vec2 spiral_tap(int i, int count, float turns, float rotation_angle) {
    float alpha = (float(i) + 0.5) / float(count);
    float angle = 6.28318530717959 * turns * alpha + rotation_angle;
    return alpha * mirrored(vec2(cos(angle), sin(angle)));
}
