// The bitmask over the depth surface (lib/bitmask.glsl), marched to the radius in space or as its author's implementation does.
#include "contract/ao_pass.glsl"
#include "lib/bitmask.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

uint tap_sectors(vec2 tap_px, vec3 position, ViewSlice slice, float side) {
    vec3 front = into_slice(tap_position(tap_px) - position, slice);
    return is_tap(front, slice, side) ? sectors_behind(front, slice, side) : 0u;
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

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec2 noise = marching_noise();
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        float azimuth = slice_azimuth(i, noise.x);
        uint hidden = 0u;
        ViewSlice slice;
        if (p_march == march_radius) {
            slice = view_slice(azimuth, position, normal, line_of_sight);
            hidden = hidden_in_slice(image_px, position, slice, noise.y);
        } else {
            slice = screen_slice(azimuth, position, normal, line_of_sight);
            hidden = hidden_sectors_by_steps(image_px, position, slice, -1.0, noise.y) |
                     hidden_sectors_by_steps(image_px, position, slice, 1.0, noise.y);
        }
        sum += open_of(hidden, slice);
    }
#ifdef OPEN_CONE
    write_mean_direction(open_sum, open_weight, normal);
#endif
    return limited_visibility(sum / float(p_slices));
}
