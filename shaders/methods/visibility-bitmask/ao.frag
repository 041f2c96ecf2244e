// Visibility bitmask (Therrien, Levesque and Gilet 2023): V = mean over slices of 1 - popcount/32, or of the open
// sectors' exact cosine-weighted parts.
#include "contract/ao_pass.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/open_slice.glsl"
#include "lib/slice.glsl"

const int kSectors = 32;

uint low_bits(uint count) { return count >= 32u ? 0xffffffffu : (1u << count) - 1u; }

// The sectors between two places of the half circle, in [0,1].
uint sectors_between(float low, float high) {
    float scale = float(kSectors);
    uint first, last;
    if (p_rounding == rounding_nearest) {
        first = uint(round(low * scale));
        last = uint(round(high * scale));
    } else {
        first = uint(low * scale);
        last = min(first + uint(ceil((high - low) * scale)), 32u);
    }
    return low_bits(last) & ~low_bits(first);
}

float count_bits(uint bits) {
    bits -= (bits >> 1u) & 0x55555555u;
    bits = (bits & 0x33333333u) + ((bits >> 2u) & 0x33333333u);
    bits = (bits + (bits >> 4u)) & 0x0f0f0f0fu;
    return float((bits * 0x01010101u) >> 24u);
}

// What a surface hides between its front, from the pixel, and the back behind it.
uint sectors_behind(vec3 front, ViewSlice slice, float side) {
    float start = kHalfPi - slice.normal_angle;
    vec3 back = front - slice.view * p_thickness;
    float front_place = clamp((side * slice_angle(front, slice) + start) / kPi, 0.0, 1.0);
    float back_place = clamp((side * slice_angle(back, slice) + start) / kPi, 0.0, 1.0);
    return sectors_between(min(front_place, back_place), max(front_place, back_place));
}

uint hidden_sectors(vec2 image_px, vec3 position, ViewSlice slice, float side, float shift) {
    vec2 reach_px = side * p_radius * slice.image_px;
    float least = inversesqrt(max(dot(reach_px, reach_px), 1e-12));  // one pixel
    uint hidden = 0u;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float part = max(pow((float(j) + shift) / float(p_steps), p_step_power), least);
        vec3 front = into_slice(tap_position(image_px + part * reach_px) - position, slice);
        bool ahead = side * dot(front, slice.along) > 0.0;  // not the pixel itself
        bool counts = ahead && dot(front, front) < p_radius * p_radius && part <= 1.0;
        hidden |= counts ? sectors_behind(front, slice, side) : 0u;
    }
    return hidden;
}

// As its author's implementation marches: even steps of half the projected radius, or of a pixel where that is more, up to
// the picture's edge, with no limit in space.
uint hidden_sectors_by_steps(vec2 image_px, vec3 position, ViewSlice slice, float side, float shift) {
    vec2 direction = side * normalize(slice.image_px);
    float reach_px = max(0.5 * p_radius * pixels_per_metre(-position.z), float(p_steps));
    uint hidden = 0u;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float step_px = reach_px / float(p_steps + 1);
        vec2 tap_px = image_px + direction * max(step_px * abs(float(j) + shift), float(j + 1));
        int mip = p_mips ? min((j + 1) / 2, 4) : 0;
        bool counts = all(greaterThan(tap_px, vec2(0.0))) && all(lessThan(tap_px, u_size_px));
        vec3 front = view_position(tap_px, tap_mip_depth(inside_picture(tap_px), mip)) - position;
        hidden |= counts ? sectors_behind(front, slice, side) : 0u;
    }
    return hidden;
}

// x: turn of the slices, y: shift of the steps, which may be negative.
vec2 marching_noise() {
    if (p_noise != noise_implementation) return pixel_noise().xy;
    ivec2 texel = noise_texel();
    float jitter = 2.0 * hash_noise(texel, 0u).x - 1.0;
    return vec2(interleaved_gradient(vec2(texel)), 0.25 * float((texel.y - texel.x) & 3) + jitter);
}

// ∫_0^θ cos(t-γ) |sin t| dt at the i-th edge between sectors, θ = γ - π/2 + iπ/32: the slice's arc, with the sign of
// the sine; cos(2θ-γ) = -cos(γ + iπ/16) needs no cosine of its own.
float cosine_part(int i, float gamma, float cos_gamma, float sin_gamma) {
    float angle = gamma - kHalfPi + float(i) * (kPi / float(kSectors)), turn = float(i) * (kTwoPi / float(kSectors));
    float arc = 0.25 * (cos_gamma + 2.0 * angle * sin_gamma + cos_gamma * cos(turn) - sin_gamma * sin(turn));
    return angle < 0.0 ? -arc : arc;
}

float open_part(uint hidden, ViewSlice slice) {
    if (p_weights == weights_uniform) return 1.0 - count_bits(hidden) / float(kSectors);
    float gamma = slice.normal_angle, cos_gamma = cos(gamma), sin_gamma = sin(gamma), open = 0.0;
    float below = cosine_part(0, gamma, cos_gamma, sin_gamma);
    for (int i = 0; i < kSectors; ++i) {
        float above = cosine_part(i + 1, gamma, cos_gamma, sin_gamma);
        open += (hidden >> uint(i) & 1u) == 0u ? above - below : 0.0;
        below = above;
    }
    return slice.normal_length * open;
}

#ifdef OPEN_CONE
void add_open_sectors(uint hidden, ViewSlice slice) {
    float first = slice.normal_angle - kHalfPi;
    vec3 below = uniform_arc(first);
    for (int i = 0; i < kSectors; ++i) {
        vec3 above = uniform_arc(first + float(i + 1) * (kPi / float(kSectors)));
        if ((hidden >> uint(i) & 1u) == 0u) add_open_arc(above - below, slice);
        below = above;
    }
}
#endif

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec2 noise = marching_noise();
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        float azimuth = (float(i) + noise.x) * (kPi / float(p_slices));
        uint hidden = 0u;
        ViewSlice slice;
        if (p_march == march_radius) {
            slice = view_slice(azimuth, position, normal, line_of_sight);
            hidden = hidden_sectors(image_px, position, slice, -1.0, noise.y) |
                     hidden_sectors(image_px, position, slice, 1.0, noise.y);
        } else {
            slice = screen_slice(azimuth, position, normal, line_of_sight);
            hidden = hidden_sectors_by_steps(image_px, position, slice, -1.0, noise.y) |
                     hidden_sectors_by_steps(image_px, position, slice, 1.0, noise.y);
        }
        sum += open_part(hidden, slice);
#ifdef OPEN_CONE
        add_open_sectors(hidden, slice);
#endif
    }
#ifdef OPEN_CONE
    write_mean_direction(open_sum, open_weight, normal);
#endif
    return limited_visibility(sum / float(p_slices));
}
