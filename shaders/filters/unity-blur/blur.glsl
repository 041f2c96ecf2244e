// Unity's blur: visibility weighted by how nearly normals agree. Background agrees with nothing.
#include "contract/filter_pass.glsl"

vec3 normal_at(ivec2 texel) {
    ivec2 inside = clamp(texel, ivec2(0), ivec2(u_size_px) - 1);
    return is_background(filter_depth(inside)) ? vec3(0.0) : texelFetch(u_normal_smooth, inside, 0).xyz;
}

// x: the weighted value, y: its weight.
vec2 weighted(float value, vec3 tap_normal, vec3 normal, float weight) {
    weight *= smoothstep(p_least_cosine, 1.0, dot(tap_normal, normal));
    return weight * vec2(value, 1.0);
}

// Between two texels `near` and `near + 1` along `step`.
vec2 tap_between(ivec2 texel, ivec2 step, int near, float fraction, vec3 normal, float weight) {
    ivec2 first = texel + near * step, second = first + step;
    float value = mix(tap_visibility(first), tap_visibility(second), fraction);
    return weighted(value, mix(normal_at(first), normal_at(second), fraction), normal, weight);
}

// Nine Gaussian taps along a direction, of which linear interpolation makes five.
float blurred(ivec2 texel, ivec2 step) {
    vec3 normal = normal_at(texel);
    vec2 sum = 0.2270270270 * vec2(tap_visibility(texel), 1.0);
    for (int side = -1; side <= 1; side += 2) {
        sum += tap_between(texel, side * step, 1, 0.3846153846, normal, 0.3162162162);
        sum += tap_between(texel, side * step, 3, 0.2307692308, normal, 0.0702702703);
    }
    return sum.x / sum.y;
}
