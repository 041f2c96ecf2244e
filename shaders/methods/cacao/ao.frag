// Adaptive screen-space ambient occlusion (Strugar 2016; AMD 2020): taps in pairs on opposite sides, their obscurance
// averaged with less weight far in front; strength, limit and power over all.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/side_edges.glsl"

// AMD draws the picture as 2x2 smaller ones of every second pixel, and a pixel's taps stay within its own.
const float kInterleaved = 2.0;

// The four neighbours, in the pixel's smaller picture.
struct Sides {
    vec3 points[4];
    vec4 open;
};

// Turn and scale of AMD's pattern: one of five in each of the four smaller pictures. x: quarter turns, y: scale.
vec2 interleaved_turn() {
    ivec2 texel = noise_texel(), own = texel / 2;
    int picture = texel.x % 2 + 2 * (texel.y % 2), place = (2 * own.y + own.x) % 5;
    int part = place < 2 ? place : 6 - place;
    float scale = 1.0 + (float(picture) - 1.5 + (float(part) - 2.0) / 5.0) * 0.07;
    return vec2(float(picture) + float(part) / 5.0, scale);
}

mat2 pattern() {
    if (p_noise != noise_interleaved) return rotation(kTwoPi * pixel_noise().x);
    vec2 turn = interleaved_turn();
    float angle = turn.x * kHalfPi;
    // Turned and mirrored.
    return turn.y * mat2(kMirror * vec2(cos(angle), -sin(angle)), kMirror * vec2(-sin(angle), -cos(angle)));
}

float obscurance_of(vec3 v, vec3 normal, float radius) {
    float distance_squared = dot(v, v);
    float cosine = distance_squared > 0.0 ? dot(v, normal) * inversesqrt(distance_squared) : 0.0;
    return max(0.0, cosine - p_horizon_threshold) * max(0.0, 1.0 - distance_squared / (radius * radius));
}

// Obscurance and weight of a tap.
vec2 weighed(vec3 v, vec3 normal, float radius) {
    float weight = 1.0 - p_halo + p_halo * clamp(2.0 - max(v.z, 0.0) / p_radius, 0.0, 1.0);
    return weight * vec2(obscurance_of(v, normal, radius), 1.0);
}

vec3 tapped(vec2 image_px, vec2 offset_px) {
    if (!p_interleaved) return tap_position(image_px + offset_px);
    vec2 own_px = offset_px / kInterleaved;
    float level = log2(max(length(own_px), 1e-3)) - p_mip_offset;
    int mip = int(clamp(level, 0.0, 3.0) + 0.5);
    // A level of a smaller picture is one coarser of the whole.
    vec2 tap_px = image_px + kInterleaved * round(own_px);
    return view_position(tap_px, tap_mip_depth(inside_picture(tap_px), mip > 0 ? mip + 1 : 0));
}

Sides sides_of(vec2 image_px, vec3 position, vec3 normal) {
    Sides sides;
    sides.points = vec3[4](position, position, position, position);
    sides.open = vec4(1.0);
    if (!p_edges) return sides;
    vec4 depths, facing = vec4(1.0);
    for (int i = 0; i < 4; ++i) {
        vec2 side_px = image_px + kInterleaved * side_offset(i), texel = floor(inside_picture(side_px));
        depths[i] = texel_linear_depth(texel);
        sides.points[i] = view_position(side_px, depths[i]);
        if (p_normal_edges) {
            COUNT_TAP
            facing[i] = open_by_normal(normal, picture_texel(u_normal_geometric, texel).xyz);
        }
    }
    sides.open = open_by_depth(depths, -position.z) * facing;
    return sides;
}

// Where there are edges on opposite sides, thin things stay open.
float edge_fade(vec4 open) {
    vec2 closed = clamp(0.35 * (1.0 - open.xz - open.yw), 0.0, 1.0);
    return clamp(1.0 - closed.x - closed.y, 0.0, 1.0);
}

// The radius shrinks, to a fifth at the eye, where it would fill the picture.
float near_radius(vec3 position) {
#if ORTHOGRAPHIC
    return p_radius;
#else
    if (p_near_limit == 0.0) return p_radius;
    float half_height = 0.5 * u_pixel_size.y * u_size_px.y;
    return p_radius * (0.2 + 0.8 * clamp(length(position) * half_height / (p_near_limit * p_radius), 0.0, 1.0));
#endif
}

// Godot's disc shrinks toward the picture's edge, to six tenths.
float border_part(vec2 image_px) {
    vec2 inward = min(image_px, u_size_px - image_px) / u_size_px;
    return p_border_shrink ? clamp(10.0 * min(inward.x, inward.y) + 0.6, 0.0, 1.0) : 1.0;
}

// 1 near, 0 far.
float distance_fade(float depth) {
    return p_fade_to > p_fade_from ? clamp((p_fade_to - depth) / (p_fade_to - p_fade_from), 0.0, 1.0) : 1.0;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    Sides sides = sides_of(image_px, position, normal);
    position *= 1.0 - p_toward_viewer;
    float radius = near_radius(position);
    float radius_px = border_part(image_px) * p_disc_part * radius * pixels_per_metre(-position.z);
    mat2 turn = pattern();
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 4 && p_edges; ++i)
        sum.x += p_detail * sides.open[i] * obscurance_of(sides.points[i] - position, normal, 0.5 * radius);
    position.z *= 1.0 - p_depth_pull;
#pragma unroll
    for (int i = 0; i < p_pairs; ++i) {
        vec2 offset_px = radius_px * (turn * k_disc[i].xy);
        sum += weighed(tapped(image_px, offset_px) - position, normal, radius);
        sum += weighed(tapped(image_px, -offset_px) - position, normal, radius);
    }
    // With halo = 1 the weights may vanish: then nothing is near enough to obscure.
    float obscurance = sum.y > 0.0 ? min(p_strength * sum.x / sum.y, p_limit) : 0.0;
    obscurance *= distance_fade(-position.z) * edge_fade(sides.open);
    return pow(1.0 - obscurance, p_power);
}
