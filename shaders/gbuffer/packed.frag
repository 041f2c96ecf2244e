// What is left of depth and normal in one RGBA8 texture (Gravås, Image-space Ambient Obscurance in WebGL, 2013, sections
// 3.1.2, 3.1.5 and appendix A): 16 bits of linear depth, a Lambert azimuthal projection of the normal. Packed and unpacked
// again, so that any method reads it. Background stays background; as published it would wrap to the near plane.
#include "contract/view.glsl"

uniform sampler2D u_linear_depth;
uniform sampler2D u_normal;

layout(location = 0) out float o_linear_depth;
layout(location = 1) out vec4 o_normal;

vec4 to_8_bits(vec4 v) { return floor(clamp(v, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }

vec2 packed_depth(float d) {
    vec2 digits = fract(vec2(1.0, 255.0) * d);
    return digits - vec2(digits.y / 255.0, 0.0);
}
float unpacked_depth(vec2 digits) { return digits.x + digits.y / 255.0; }

vec2 packed_normal(vec3 n) { return n.xy / sqrt(max(8.0 * n.z + 8.0, 1e-6)) + 0.5; }
vec3 unpacked_normal(vec2 code) {
    vec2 f = 4.0 * code - 2.0;
    float length_squared = min(dot(f, f), 4.0);
    return vec3(f * sqrt(1.0 - length_squared / 4.0), 1.0 - length_squared / 2.0);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(u_linear_depth, texel, 0).r;
    float d = clamp((depth - u_near) / (u_far - u_near), 0.0, 65534.0 / 65535.0);
    vec4 code = to_8_bits(vec4(packed_normal(texelFetch(u_normal, texel, 0).xyz), packed_depth(d)));
    float unpacked = min(mix(u_near, u_far, unpacked_depth(code.zw)), u_far * (1.0 - 2e-7));
    o_linear_depth = is_background(depth) ? u_far : unpacked;
    o_normal = vec4(normalize(unpacked_normal(code.xy)), 0.0);
}
