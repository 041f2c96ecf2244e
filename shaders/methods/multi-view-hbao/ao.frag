// HBAO from several cameras, whose occlusions are averaged by how sure each is of the point (Vardis, Papaioannou and
// Gaitatzes 2013, after their own program of HBAO).
#include "contract/ao_pass.glsl"
#include "contract/side_cameras.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/shading_normal.glsl"

const int kMain = -1;                  // the picture's own camera; side cameras count from 0
const float kLeastConfidence = 0.001;  // so that no sum is 0

struct Finding {
    float occlusion;  // the mean over slices of the highest sine over the tangent plane
    float nearness;   // 1 - mean distance / R; what the camera does not see counts as R away
};

// The surface that the camera sees at the place of this point of its space, and whether it sees the place at all: neither
// edge of the picture nor near plane leaves it out. A place beyond an edge reads the edge, as published.
bool is_in_front(vec3 point) { return -point.z > u_near; }

vec3 surface_at(int camera, vec3 point) {
    if (camera == kMain) return tap_position(inside_picture(image_of(point)));
    vec2 side_px = clamp(side_image_of(point), vec2(0.5), u_side_size_px - 0.5);
    return side_position(floor(side_px) + 0.5, side_texel(side_px, camera).r);
}

Finding found_from(int camera, vec3 point, vec3 normal, mat3 frame, vec4 noise) {
    Finding found = Finding(0.0, 0.0);
    float step_length = p_radius / float(p_steps), distances = 0.0;
    for (int i = 0; i < p_slices; ++i) {
        float angle = (float(i) + noise.x) * (kTwoPi / float(p_slices)), highest = 0.0;
        vec3 along = frame[0] * cos(angle) + frame[1] * sin(angle);
        for (int j = 1; j <= p_steps; ++j) {
            vec3 place = point + along * ((float(j) - noise.y) * step_length);
            if (!is_in_front(place)) {
                distances += p_radius;
                continue;
            }
            vec3 surface = surface_at(camera, place), v = surface - point;
            float apart = length(v);
            distances += place.z > surface.z ? min(apart, p_radius) : p_radius;
            float height = apart > 0.0 ? dot(v, normal) / apart : 0.0;
            if (height > highest && apart <= p_radius) {
                highest = height;
                along = v / apart;
            }
        }
        found.occlusion += highest / float(p_slices);
    }
    found.nearness = 1.0 - distances / (float(p_slices * p_steps) * p_radius);
    return found;
}

vec3 toward_camera(vec3 point) {
#if ORTHOGRAPHIC
    return vec3(0.0, 0.0, 1.0);
#else
    return normalize(-point);
#endif
}

// Adds the camera's occlusion and its confidence to their sums.
void add_camera(int camera, vec3 point, vec3 normal, mat3 frame, vec4 noise, inout vec2 sums) {
    Finding found = found_from(camera, point, normal, frame, noise);
    float facing = max(dot(normal, toward_camera(point)), 0.0);
    float confidence = mix(found.nearness, facing, p_facing_weight) + kLeastConfidence;
    sums += confidence * vec2(found.occlusion, 1.0);
}

float visibility(vec2 image_px, vec3 position) {
    vec3 normal = shading_normal(), point = position + p_lift * normal;
    vec4 noise = pixel_noise();
    mat3 frame = basis_toward(normal, vec3(0.0, 1.0, 0.0));
    vec2 sums = vec2(0.0);
    add_camera(kMain, point, normal, frame, noise, sums);
    // Mesa keeps the inputs of a loop that never turns, but not those of a branch that is never taken.
    if (p_side_cameras > 0) {
        for (int camera = 0; camera < p_side_cameras; ++camera) {
            mat3 turned = mat3(side_direction(camera, frame[0]), side_direction(camera, frame[1]), vec3(0.0));
            add_camera(camera, side_point(camera, point), side_direction(camera, normal), turned, noise, sums);
        }
    }
    return limited_visibility(1.0 - sums.x / sums.y);
}
