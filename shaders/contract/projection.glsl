// A camera's projection, the same for the view's own camera and for those beside it: all have one kind. Camera space is
// right-handed, the camera looks down -z, x to the right, y up. Image positions are in pixels from the top left corner, y
// downwards: the centre of pixel (i, j) is (i+½, j+½). ORTHOGRAPHIC is 0 or 1, set by the program.
struct CameraPicture {
    vec2 size_px;     // width, height
    vec2 pixel_size;  // metres a pixel at depth 1 (perspective) or anywhere (orthographic)
};

// What a pixel's square measures at this depth, metres. Depth is always the positive -z.
float footprint_in(CameraPicture picture, float depth) {
#if ORTHOGRAPHIC
    return picture.pixel_size.y;
#else
    return picture.pixel_size.y * depth;
#endif
}

// Camera-space position of an image position at a depth.
vec3 position_in(CameraPicture picture, vec2 image_px, float depth) {
    vec2 offset = (image_px - 0.5 * picture.size_px) * vec2(picture.pixel_size.x, -picture.pixel_size.y);
#if ORTHOGRAPHIC
    return vec3(offset, -depth);
#else
    return vec3(offset * depth, -depth);
#endif
}

// Image position of a camera-space point in front of the camera.
vec2 image_in(CameraPicture picture, vec3 point) {
#if ORTHOGRAPHIC
    vec2 offset = point.xy;
#else
    vec2 offset = point.xy / -point.z;
#endif
    return 0.5 * picture.size_px + offset / vec2(picture.pixel_size.x, -picture.pixel_size.y);
}
