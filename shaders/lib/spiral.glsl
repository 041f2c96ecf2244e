// Taps on a spiral (McGuire, Mara and Luebke, Scalable Ambient Obscurance, 2012).
#include "contract/mirror.glsl"

// The i-th of `count` taps: angle and part of the radius, α = (i + ½)/count.
vec2 spiral_tap(int i, int count, float turns, float rotation_angle) {
    float alpha = (float(i) + 0.5) / float(count);
    float angle = 6.28318530717959 * turns * alpha + rotation_angle;
    return alpha * mirrored(vec2(cos(angle), sin(angle)));
}

// The i-th of `count` points that fill the unit disc evenly, on a spiral of golden angles (Vogel, A better way to construct
// the sunflower head, 1979). In a surface's own frame, which is mirrored where the run is.
vec2 golden_spiral(int i, int count, float rotation_angle) {
    float angle = 2.399963 * float(i) + rotation_angle;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}
