// One level of the depth mips from the level above it (u_source_level; -1 copies the full picture).
#include "contract/mirror.glsl"

uniform sampler2D u_source;
uniform int u_source_level;
uniform float u_radius;  // metres, WEIGHTED only

layout(location = 0) out float o_depth;

ivec2 source_size;
float source_depth(ivec2 texel) { return texelFetch(u_source, min(texel, source_size - 1), u_source_level).r; }

#if WEIGHTED
// The mean of the four, those that lie in front of the farthest by more than its falloff left out (Intel, XeGTAO, 2021).
float reduced(ivec2 texel) {
    vec4 d = vec4(source_depth(2 * texel), source_depth(2 * texel + ivec2(1, 0)), source_depth(2 * texel + ivec2(0, 1)),
                  source_depth(2 * texel + 1));
    float farthest = max(max(d.x, d.y), max(d.z, d.w));
    const float kRadiusScale = 0.75, kRadiusMultiplier = 1.457, kFalloffRange = 0.615;
    float radius = kRadiusScale * kRadiusMultiplier * u_radius;
    vec4 weights = clamp((radius - (farthest - d)) / max(kFalloffRange * radius, 1e-20), 0.0, 1.0);
    float sum = dot(weights, vec4(1.0));
    return sum > 0.0 ? dot(weights, d) / sum : farthest;
}
#else
// One of the four, its place rotated from texel to texel (McGuire, Mara and Luebke, Scalable Ambient Obscurance, 2012).
float reduced(ivec2 texel) {
    ivec2 turned = mirrored_texel(texel, max(source_size >> 1, 1));
    return source_depth(mirrored_texel(2 * turned + ivec2(~turned.y & 1, ~turned.x & 1), source_size));
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (u_source_level < 0) {
        o_depth = texelFetch(u_source, texel, 0).r;
    } else {
        source_size = textureSize(u_source, u_source_level);
        o_depth = reduced(texel);
    }
}
