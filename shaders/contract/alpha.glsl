// Base colour of a glTF material: factor x texture, level 0, bilinear, glTF's wrap modes; its alpha x the vertices'. The
// twin of scene/scene.h alpha_at(), step by step, so that both paths cut the same holes: change both or none.
uniform sampler2D u_base_color_texture;
uniform vec4 u_base_color_factor;
uniform int u_has_texture;  // 0: the factor alone
uniform ivec2 u_wrap;       // 0 repeat, 1 mirrored repeat, 2 clamp to edge; for s, t

struct Tap {
    int first, second;
    float fraction;
};

int into_range(int i, int size, int wrap) {
    if (wrap == 0) return i < 0 ? i + size : (i >= size ? i - size : i);
    return clamp(i, 0, size - 1);
}

float wrapped(float u, int wrap) {
    if (isnan(u) || isinf(u)) u = 0.0;
    if (wrap == 0) return u - floor(u);
    if (wrap == 2) return min(max(u, 0.0), 1.0);
    float t = u - 2.0 * floor(u / 2.0);
    return t > 1.0 ? 2.0 - t : t;
}

Tap tap_at(float u, int size, int wrap) {
    float x = wrapped(u, wrap) * float(size) - 0.5;
    float floor_x = floor(x);
    int i = int(floor_x);
    return Tap(into_range(i, size, wrap), into_range(i + 1, size, wrap), x - floor_x);
}

struct BilinearTexels {
    vec4 t00, t10, t01, t11;
    vec2 fraction;
};

BilinearTexels base_color_texels(vec2 uv) {
    ivec2 size = textureSize(u_base_color_texture, 0);
    Tap s = tap_at(uv.x, size.x, u_wrap.x), t = tap_at(uv.y, size.y, u_wrap.y);
    return BilinearTexels(texelFetch(u_base_color_texture, ivec2(s.first, t.first), 0),
                          texelFetch(u_base_color_texture, ivec2(s.second, t.first), 0),
                          texelFetch(u_base_color_texture, ivec2(s.first, t.second), 0),
                          texelFetch(u_base_color_texture, ivec2(s.second, t.second), 0),
                          vec2(s.fraction, t.fraction));
}

float linear_mix(float a, float b, float f) { return a + (b - a) * f; }

// In [0,1].
float alpha_at(vec2 uv, float vertex_alpha) {
    if (u_has_texture == 0) return u_base_color_factor.a * vertex_alpha;
    BilinearTexels b = base_color_texels(uv);
    vec4 bytes = round(255.0 * vec4(b.t00.a, b.t10.a, b.t01.a, b.t11.a));
    float top = linear_mix(bytes.x, bytes.y, b.fraction.x), bottom = linear_mix(bytes.z, bytes.w, b.fraction.x);
    return linear_mix(top, bottom, b.fraction.y) / 255.0 * u_base_color_factor.a * vertex_alpha;
}

vec3 linear_of_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

// Linear RGB; filtered after decoding, as sRGB textures are.
vec3 albedo_at(vec2 uv) {
    if (u_has_texture == 0) return u_base_color_factor.rgb;
    BilinearTexels b = base_color_texels(uv);
    vec3 top = mix(linear_of_srgb(b.t00.rgb), linear_of_srgb(b.t10.rgb), b.fraction.x);
    vec3 bottom = mix(linear_of_srgb(b.t01.rgb), linear_of_srgb(b.t11.rgb), b.fraction.x);
    return u_base_color_factor.rgb * mix(top, bottom, b.fraction.y);
}
