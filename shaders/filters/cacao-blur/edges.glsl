// The edges of CACAO's smaller pictures, of every second pixel, as they are stored for its blur.
#include "contract/filter_pass.glsl"
#include "lib/side_edges.glsl"

const int kInterleaved = 2;

vec3 normal_at(ivec2 texel) {
    return picture_texel(u_normal_geometric, vec2(clamp(texel, ivec2(0), ivec2(u_size_px) - 1))).xyz;
}

// Two bits a side, and a little of all leaks.
vec4 stored_open(ivec2 texel) {
    vec4 depths, facing = vec4(1.0);
    vec3 normal = normal_at(texel);
    for (int i = 0; i < 4; ++i) {
        ivec2 side = texel + kInterleaved * ivec2(side_offset(i));
        depths[i] = filter_depth(side);
        if (p_normal_edges) facing[i] = open_by_normal(normal, normal_at(side));
    }
    vec4 open = open_by_depth(depths, filter_depth(texel)) * facing;
    return clamp(min(round(open * 3.05), 3.0) / 3.0 + 1.0 - p_sharpness, 0.0, 1.0);
}
