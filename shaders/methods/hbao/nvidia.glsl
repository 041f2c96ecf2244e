// HBAO as NVIDIA's pixel shader marches it. Tangents of elevations are compared; taps lie whole pixels from the pixel.

struct TangentPlane {
    vec3 along_x, along_y;  // what a pixel to the right and one down change of the position
};

vec3 nvidia_tap(vec2 tap_px) { return view_position(tap_px, tap_linear_depth(inside_picture(tap_px))); }

// Of both sides the nearer one.
vec3 nearer_difference(vec2 image_px, vec3 position, vec2 step) {
    vec3 ahead = nvidia_tap(image_px + step) - position, behind = position - nvidia_tap(image_px - step);
    return dot(ahead, ahead) < dot(behind, behind) ? ahead : behind;
}

float tangent_of(vec3 v) { return v.z * inversesqrt(max(dot(v.xy, v.xy), 1e-30)); }
float sine_of(float tangent) { return tangent * inversesqrt(1.0 + tangent * tangent); }

#ifdef OPEN_CONE
vec3 normal_of(TangentPlane plane) { return normalize(cross(plane.along_y, plane.along_x)); }
#endif

float biased_tangent(TangentPlane plane, vec2 offset_px) {
    return tangent_of(offset_px.x * plane.along_x + offset_px.y * plane.along_y) + tan(p_bias);
}

// What a tap adds above `low`; `horizon` becomes its tangent where it is the highest. The pixel itself adds nothing.
float nvidia_rise(vec3 v, float low, inout float horizon) {
    float distance_squared = dot(v, v), tangent = tangent_of(v);
    bool counts = distance_squared > 0.0 && distance_squared < p_radius * p_radius && tangent > low;
    if (!counts) return 0.0;
    horizon = max(horizon, tangent);
    return attenuation(distance_squared) * (sine_of(tangent) - sine_of(low));
}

float nvidia_direction(vec2 image_px, vec3 position, TangentPlane plane, vec2 direction, vec2 march, float jitter) {
    vec2 step_px = round(march.x * direction);
    float horizon = biased_tangent(plane, step_px);
    // A first tap within the first step, at least a pixel away.
    vec2 first_px = round(jitter * step_px + direction);
    float sum = nvidia_rise(nvidia_tap(image_px + first_px) - position, biased_tangent(plane, first_px), horizon);
    vec2 start_px = image_px + round(jitter * march.x * direction);
#pragma unroll
    for (int j = 0; j < p_steps; ++j) {
        if (float(j + 1) <= march.y - 1.0) {
            vec3 v = nvidia_tap(start_px + float(j + 1) * step_px) - position;
            sum += nvidia_rise(v, horizon, horizon);
        }
    }
#ifdef OPEN_CONE
    add_horizon(direction, normal_of(plane), max(atan(horizon) - atan(biased_tangent(plane, step_px)), 0.0));
#endif
    return sum;
}

// Length of a step in pixels, and their number: no more than pixels in the radius, none beyond the longest march, whose
// last step comes and goes by the noise.
vec2 nvidia_march(float radius_px, float jitter) {
    float steps = min(float(p_steps), radius_px), step_px = radius_px / (steps + 1.0);
    float most_px = p_most_radius * min(u_size_px.x, u_size_px.y);
    if (most_px / step_px >= steps) return vec2(step_px, steps);
    steps = max(floor(most_px / step_px + jitter), 1.0);
    return vec2(most_px / steps, steps);
}

float nvidia_visibility(vec2 image_px, vec3 position) {
    float radius_px = p_radius * pixels_per_metre(-position.z);
#ifdef OPEN_CONE
    if (radius_px < 1.0) write_open_cone(centre_normal_geometric(), kHalfPi);
#endif
    if (radius_px < 1.0) return 1.0;
    vec4 noise = pixel_noise();
    vec2 march = nvidia_march(radius_px, noise.y);
    TangentPlane plane = TangentPlane(nearer_difference(image_px, position, vec2(1.0, 0.0)),
                                      nearer_difference(image_px, position, vec2(0.0, 1.0)));
    float occlusion = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        occlusion += nvidia_direction(image_px, position, plane, direction, march, noise.y);
    }
#ifdef OPEN_CONE
    write_horizons(p_directions);
#endif
    return limited_visibility(1.0 - occlusion * p_strength / float(p_directions));
}
