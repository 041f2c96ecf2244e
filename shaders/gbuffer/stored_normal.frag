// A normal as a G-buffer of few channels gives it back, so that any method reads it. STORED is one of the formats below.
uniform sampler2D u_normal;

layout(location = 0) out vec4 o_normal;

vec2 to_8_bits(vec2 v) { return floor(clamp(v, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }

// Two of the channels of an RGBA8 texture: a Lambert azimuthal projection (Gravås, Image-space Ambient Obscurance in WebGL,
// 2013, section 3.1.5 and appendix A).
vec2 packed_normal(vec3 n) { return n.xy / sqrt(max(8.0 * n.z + 8.0, 1e-6)) + 0.5; }
vec3 unpacked_normal(vec2 code) {
    vec2 f = 4.0 * code - 2.0;
    float length_squared = min(dot(f, f), 4.0);
    return vec3(f * sqrt(1.0 - length_squared / 4.0), 1.0 - length_squared / 2.0);
}

vec3 stored(vec3 n) {
#if STORED == TWO_BYTES
    return normalize(unpacked_normal(to_8_bits(packed_normal(n))));
#elif STORED == X_AND_Y
    return vec3(n.xy, sqrt(max(1.0 - dot(n.xy, n.xy), 0.0)));
#endif
}

void main() { o_normal = vec4(stored(texelFetch(u_normal, ivec2(gl_FragCoord.xy), 0).xyz), 0.0); }
