// Base colour of a glTF material: factor x texture, level 0, bilinear, integer wrap. The twin of
// scene/scene.h alpha_at(), so that both paths cut the same holes; change both or none.
uniform sampler2D u_base_color_texture;
uniform vec4 u_base_color_factor;
uniform int u_has_texture;  // 0: the factor alone
uniform ivec2 u_wrap;       // 0 repeat, 1 mirrored repeat, 2 clamp to edge; for s, t

int wrapped(int i, int size, int mode) {
    if (mode == 2) return clamp(i, 0, size - 1);
    int period = mode == 1 ? 2 * size : size;
    int m = i - period * int(floor(float(i) / float(period)));
    // A quotient of large integers may round to the next one.
    m = m < 0 ? m + period : (m >= period ? m - period : m);
    return m < size ? m : period - 1 - m;
}

vec4 base_color_texel(ivec2 texel, ivec2 size) {
    return texelFetch(u_base_color_texture,
                      ivec2(wrapped(texel.x, size.x, u_wrap.x), wrapped(texel.y, size.y, u_wrap.y)), 0);
}

vec3 linear_of_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

struct BilinearTexels {
    vec4 t00, t10, t01, t11;
    vec2 weight;
};

BilinearTexels base_color_texels(vec2 uv) {
    ivec2 size = textureSize(u_base_color_texture, 0);
    vec2 at = uv * vec2(size) - 0.5;
    vec2 low = floor(at);
    ivec2 i = ivec2(low);
    return BilinearTexels(base_color_texel(i, size), base_color_texel(i + ivec2(1, 0), size),
                          base_color_texel(i + ivec2(0, 1), size), base_color_texel(i + ivec2(1, 1), size), at - low);
}

// In [0,1].
float alpha_at(vec2 uv) {
    if (u_has_texture == 0) return u_base_color_factor.a;
    BilinearTexels b = base_color_texels(uv);
    float top = mix(b.t00.a, b.t10.a, b.weight.x), bottom = mix(b.t01.a, b.t11.a, b.weight.x);
    return u_base_color_factor.a * mix(top, bottom, b.weight.y);
}

// Linear RGB; filtered after decoding, as sRGB textures are.
vec3 albedo_at(vec2 uv) {
    if (u_has_texture == 0) return u_base_color_factor.rgb;
    BilinearTexels b = base_color_texels(uv);
    vec3 top = mix(linear_of_srgb(b.t00.rgb), linear_of_srgb(b.t10.rgb), b.weight.x);
    vec3 bottom = mix(linear_of_srgb(b.t01.rgb), linear_of_srgb(b.t11.rgb), b.weight.x);
    return u_base_color_factor.rgb * mix(top, bottom, b.weight.y);
}
