// The bitmask over several depths a texel: a tap hides what any of them hides. Peeled layers of closed meshes lie in pairs,
// where a solid begins and where it ends: they are the thickness that the method else guesses.
#include "contract/ao_pass.glsl"
#include "contract/depth_layers.glsl"
#include "lib/bitmask.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"

uint sectors_of_layer(vec2 tap_px, float depth, float next, vec3 position, ViewSlice slice, float side) {
    vec3 front = into_slice(layer_position(tap_px, depth) - position, slice);
    if (is_background(depth) || !is_tap(front, slice, side)) return 0u;
    bool has_end = p_back == back_next_layer && p_sampling == sampling_peeled && !is_background(next);
    if (!has_end) return sectors_behind(front, slice, side);
    return sectors_from_to(front, into_slice(layer_position(tap_px, next) - position, slice), slice, side);
}

uint tap_sectors(vec2 tap_px, vec3 position, ViewSlice slice, float side) {
    bool in_pairs = p_back == back_next_layer && p_sampling == sampling_peeled;
    uint hidden = 0u;
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        hidden |= sectors_of_layer(tap_px, depths.x, depths.y, position, slice, side);
        hidden |= sectors_of_layer(tap_px, depths.z, depths.w, position, slice, side);
        if (in_pairs) continue;
        hidden |= sectors_of_layer(tap_px, depths.y, u_far, position, slice, side);
        hidden |= sectors_of_layer(tap_px, depths.w, u_far, position, slice, side);
    }
    return hidden;
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = centre_normal_geometric();
    vec3 line_of_sight = view_ray(image_px);
    vec2 noise = pixel_noise().xy;
    float sum = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        ViewSlice slice = view_slice(slice_azimuth(i, noise.x), position, normal, line_of_sight);
        sum += open_of(hidden_in_slice(image_px, position, slice, noise.y), slice);
    }
#ifdef OPEN_CONE
    write_mean_direction(open_sum, open_weight, normal);
#endif
    return limited_visibility(sum / float(p_slices));
}
