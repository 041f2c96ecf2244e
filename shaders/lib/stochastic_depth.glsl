// Where a method looks at all depths of a texel, and where the first one is enough (Vermeer 2020, section 6.3): parameter
// `use` is always; beyond_radius or beyond_part, the first surface lies farther from the point than R or .3 R; angle_skip,
// the first surface is not behind what could add anything; beyond_part_and_angle_skip.
#include "contract/depth_layers.glsl"

const float kNearPart = 0.3;

bool first_is_enough(float distance_squared) {
    if (p_use == use_beyond_radius) return distance_squared <= p_radius * p_radius;
    if (p_use == use_beyond_part || p_use == use_beyond_part_and_angle_skip)
        return distance_squared <= kNearPart * kNearPart * p_radius * p_radius;
    return false;
}

bool skips_by_angle() { return p_use == use_angle_skip || p_use == use_beyond_part_and_angle_skip; }

// AO = (AO · strength)^exponent of the occlusion (section 8.1).
float with_strength(float occlusion) {
    float stronger = occlusion * p_strength;
    return p_exponent == 1.0 ? stronger : pow(max(stronger, 0.0), p_exponent);
}
