// The camera, as scene/camera.h has it. View space is right-handed, the camera looks down -z, x to the right, y up.
// Image positions are in pixels from the top left corner, y downwards: the centre of pixel (i, j) is (i+½, j+½).
// ORTHOGRAPHIC is 0 or 1, set by the program.
uniform vec2 u_size_px;            // width, height
uniform vec2 u_pixel_size;         // metres a pixel at depth 1 (perspective) or anywhere (orthographic)
uniform float u_near;              // metres
uniform float u_far;               // metres; the depth of the background

// Depth is always the positive view depth -z in metres.
bool is_background(float depth) { return depth >= u_far; }

// What a pixel's square measures at this depth, metres.
float pixel_footprint(float depth) {
#if ORTHOGRAPHIC
    return u_pixel_size.y;
#else
    return u_pixel_size.y * depth;
#endif
}

// R_px = R H / (2 |z| tan(fovy/2)).
float pixels_per_metre(float depth) { return 1.0 / pixel_footprint(depth); }

// View-space position of an image position at a depth.
vec3 view_position(vec2 image_px, float depth) {
    vec2 offset = (image_px - 0.5 * u_size_px) * vec2(u_pixel_size.x, -u_pixel_size.y);
#if ORTHOGRAPHIC
    return vec3(offset, -depth);
#else
    return vec3(offset * depth, -depth);
#endif
}

// Along the line of sight away from the viewer, not unit: P changes by this for a unit of depth.
vec3 view_ray(vec2 image_px) {
#if ORTHOGRAPHIC
    return vec3(0.0, 0.0, -1.0);
#else
    return view_position(image_px, 1.0);
#endif
}

// Image position of a view-space point in front of the camera.
vec2 image_of(vec3 view_point) {
#if ORTHOGRAPHIC
    vec2 offset = view_point.xy;
#else
    vec2 offset = view_point.xy / -view_point.z;
#endif
    return 0.5 * u_size_px + offset / vec2(u_pixel_size.x, -u_pixel_size.y);
}
