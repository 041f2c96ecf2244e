// The camera, as scene/camera.h has it: its space is view space.
#include "contract/projection.glsl"

uniform vec2 u_size_px;     // width, height
uniform vec2 u_pixel_size;  // metres a pixel at depth 1 (perspective) or anywhere (orthographic)
uniform float u_near;       // metres
uniform float u_far;        // metres; the depth of the background

CameraPicture view_picture() { return CameraPicture(u_size_px, u_pixel_size); }

bool is_background(float depth) { return depth >= u_far; }

// What a pixel's square measures at this depth, metres.
float pixel_footprint(float depth) { return footprint_in(view_picture(), depth); }

// R_px = R H / (2 |z| tan(fovy/2)).
float pixels_per_metre(float depth) { return 1.0 / pixel_footprint(depth); }

// View-space position of an image position at a depth.
vec3 view_position(vec2 image_px, float depth) { return position_in(view_picture(), image_px, depth); }

// Along the line of sight away from the viewer, not unit: P changes by this for a unit of depth.
vec3 view_ray(vec2 image_px) {
#if ORTHOGRAPHIC
    return vec3(0.0, 0.0, -1.0);
#else
    return view_position(image_px, 1.0);
#endif
}

// Image position of a view-space point in front of the camera.
vec2 image_of(vec3 view_point) { return image_in(view_picture(), view_point); }
