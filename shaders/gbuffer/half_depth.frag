// A linear depth of half the resolution: the middle texel of each block of 2x2, so that it is a surface's and no mean
// of two.
uniform sampler2D u_source;

layout(location = 0) out float o_depth;

void main() {
    o_depth = texelFetch(u_source, min(2 * ivec2(gl_FragCoord.xy) + 1, textureSize(u_source, 0) - 1), 0).r;
}
