// Stochastic-depth HBAO+ (Vermeer 2020, algorithm 8): a tap counts, of all depths of its texel, the one that counts most.
#include "contract/ao_pass.glsl"
#include "lib/hbao_plus.glsl"
#include "lib/limits.glsl"
#include "lib/stochastic_depth.glsl"
#include "side.glsl"

int only_layer = -1;  // the one layer that taps read; -1: all

TapPart part_of_layers(vec2 tap_px, vec3 position, vec3 normal) {
    TapPart most = TapPart(0.0, 0.0);
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        for (int k = 0; k < 4; ++k) {
            if (is_background(depths[k]) || (only_layer >= 0 && only_layer != 4 * picture + k)) continue;
            TapPart part = part_of(layer_position(tap_px, depths[k]) - position, normal);
            most.occlusion = max(most.occlusion, part.occlusion);
            most.height = max(most.height, part.height);
        }
    }
    return most;
}

TapPart tap_part(int j, vec2 direction, vec2 image_px, vec3 position, vec3 normal, float shift) {
    float step_px = p_radius * pixels_per_metre(-position.z) / float(p_steps + 1);
    vec2 tap_px = image_px + direction * ((float(j + 1) + shift) * step_px);
    if (p_use == use_always) return part_of_layers(tap_px, position, normal);
    vec3 first = tap_position(tap_px) - position;
    if (first_is_enough(dot(first, first))) return part_of(first, normal);
    if (skips_by_angle() && dot(first, normal) <= 0.0) return TapPart(0.0, 0.0);
    return part_of_layers(tap_px, position, normal);
}

float occlusion_at(vec2 image_px, vec3 position) {
    vec3 normal = shading_normal();
    if (p_maximum == maximum_of_tap) return tapped_occlusion(image_px, position, normal);
    float most = 0.0;
    for (only_layer = 0; only_layer < p_depth_samples; ++only_layer)
        most = max(most, tapped_occlusion(image_px, position, normal));
#ifdef OPEN_CONE
    // The horizon of a direction is the highest of all layers.
    only_layer = -1;
    turned_sum = vec3(0.0);
    cone_sum = 0.0;
    tapped_occlusion(image_px, position, normal);
#endif
    return most;
}

float visibility(vec2 image_px, vec3 position) {
    float most = occlusion_at(image_px, position);
    // Mesa keeps the inputs of a loop that never turns, but not those of a branch that is never taken.
    if (p_side_cameras > 0) {
        for (int camera = 0; camera < p_side_cameras; ++camera)
            most = max(most, side_occlusion(camera, position, shading_normal()));
    }
    return limited_visibility(1.0 - with_strength(most / float(p_directions * p_steps)));
}
