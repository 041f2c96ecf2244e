// Visibility bitmask (Therrien, Levesque and Gilet 2023): V = mean over slices of 1 - popcount/32, or of the open
// sectors' exact cosine-weighted parts. The method says which sectors of a slice are hidden.
#include "contract/inputs.glsl"
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

// Between two places of a slice, seen from the pixel.
uint sectors_from_to(vec3 front, vec3 back, ViewSlice slice, float side) {
    float start = kHalfPi - slice.normal_angle;
    float front_place = clamp((side * slice_angle(front, slice) + start) / kPi, 0.0, 1.0);
    float back_place = clamp((side * slice_angle(back, slice) + start) / kPi, 0.0, 1.0);
    return sectors_between(min(front_place, back_place), max(front_place, back_place));
}

// What a surface hides between its front, from the pixel, and the back behind it.
uint sectors_behind(vec3 front, ViewSlice slice, float side) {
    return sectors_from_to(front, front - slice.view * p_thickness, slice, side);
}

// Not the pixel itself, and within the radius.
bool is_tap(vec3 front, ViewSlice slice, float side) {
    return side * dot(front, slice.along) > 0.0 && dot(front, front) < p_radius * p_radius;
}

// What the surfaces hide that the tap at this place finds.
uint tap_sectors(vec2 tap_px, vec3 position, ViewSlice slice, float side);

uint hidden_sectors(vec2 image_px, vec3 position, ViewSlice slice, float side, float shift) {
    vec2 reach_px = side * p_radius * slice.image_px;
    float least = inversesqrt(max(dot(reach_px, reach_px), 1e-12));  // one pixel
    uint hidden = 0u;
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        float part = max(pow((float(j) + shift) / float(p_steps), p_step_power), least);
        uint sectors = tap_sectors(image_px + part * reach_px, position, slice, side);
        hidden |= part <= 1.0 ? sectors : 0u;
    }
    return hidden;
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

// Of one slice, to both sides.
uint hidden_in_slice(vec2 image_px, vec3 position, ViewSlice slice, float shift) {
    return hidden_sectors(image_px, position, slice, -1.0, shift) | hidden_sectors(image_px, position, slice, 1.0, shift);
}

// Adds the slice's signals to their sums, and gives its open part.
float open_of(uint hidden, ViewSlice slice) {
#ifdef OPEN_CONE
    add_open_sectors(hidden, slice);
#endif
    return open_part(hidden, slice);
}

float slice_azimuth(int i, float turn) { return (float(i) + turn) * (kPi / float(p_slices)); }
