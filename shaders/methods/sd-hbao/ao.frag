// Stochastic-depth HBAO (Vermeer 2020, algorithm 7): a step takes, of all depths of its texel, the one that adds most.
#include "contract/ao_pass.glsl"
#include "lib/hbao.glsl"
#include "lib/limits.glsl"
#include "lib/stochastic_depth.glsl"

Rise best_of_layers(vec2 tap_px, March march) {
    Rise best = no_rise(march);
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = tap_depths(tap_px, picture);
        for (int k = 0; k < 4; ++k) {
            Rise rise = rise_of(layer_position(tap_px, depths[k]), march);
            if (!is_background(depths[k]) && rise.occlusion > best.occlusion) best = rise;
        }
    }
    return best;
}

Rise best_rise(vec2 tap_px, March march) {
    if (p_use == use_always) return best_of_layers(tap_px, march);
    vec3 first = tap_position(tap_px), v = marched(first, march);
    if (first_is_enough(dot(v, v))) return rise_of(first, march);
    if (skips_by_angle() && sine_of_elevation(v) <= march.sin_horizon) return no_rise(march);
    return best_of_layers(tap_px, march);
}

float visibility(vec2 image_px, vec3 position) {
    return limited_visibility(1.0 - with_strength(horizon_occlusion(image_px, position)));
}
