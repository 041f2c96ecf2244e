// HBAO+ from side cameras (Vermeer 2020, algorithm 12): the point and its normal in the camera's space, the march in its
// picture.
#include "contract/depth_layers.glsl"
#include "contract/side_cameras.glsl"
#include "lib/hbao_plus.glsl"

float side_tap_occlusion(int camera, vec2 tap_px, vec3 point, vec3 normal) {
    float most = 0.0;
    for (int picture = 0; picture < depth_pictures(); ++picture) {
        vec4 depths = side_texel(tap_px, camera * depth_pictures() + picture);
        for (int k = 0; k < 4; ++k) {
            if (4 * picture + k >= p_depth_samples || is_background(depths[k])) continue;
            vec3 v = side_position(floor(tap_px) + 0.5, depths[k]) - point;
            most = max(most, part_of(v, normal).occlusion);
        }
    }
    return most;
}

// The sum over all taps; none where the camera's picture does not hold the point's place.
float side_occlusion(int camera, vec3 position, vec3 view_normal) {
    vec3 point = side_point(camera, position), normal = side_direction(camera, view_normal);
    if (!is_in_side_picture(point)) return 0.0;
    vec4 noise = pixel_noise();
    vec2 side_px = side_image_of(point);
    float step_px = p_radius * side_pixels_per_metre(-point.z) / float(p_steps + 1);
    float sum = 0.0;
    for (int i = 0; i < p_directions; ++i) {
        vec2 direction = image_direction(i, p_directions, noise.x);
        for (int j = 0; j < p_steps; ++j) {
            vec2 tap_px = side_px + direction * ((float(j + 1) + noise.y) * step_px);
            sum += side_tap_occlusion(camera, tap_px, point, normal);
        }
    }
    return sum;
}
