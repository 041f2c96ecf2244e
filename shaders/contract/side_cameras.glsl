// Further cameras beside the picture's own, each with depth layers. The descriptor's "side_layers" says where they stand
// and how the layers are gathered. A side camera's space and picture are as those of contract/view.glsl.
#include "contract/inputs.glsl"

uniform sampler2DArray u_side_layers;  // four samples a texel of each picture; one camera's after another's
uniform vec2 u_side_size_px;
uniform vec2 u_side_pixel_size;    // metres a pixel at depth 1 (perspective) or anywhere (orthographic)
uniform mat4 u_side_from_view[4];  // rotation and translation

// A point and a direction of view space in the camera's space.
vec3 side_point(int camera, vec3 view_point) { return (u_side_from_view[camera] * vec4(view_point, 1.0)).xyz; }
vec3 side_direction(int camera, vec3 direction) { return mat3(u_side_from_view[camera]) * direction; }

// The rest is in the space of a side camera, whichever it is, since all have one size and projection.
CameraPicture side_picture() { return CameraPicture(u_side_size_px, u_side_pixel_size); }
float side_pixels_per_metre(float depth) { return 1.0 / footprint_in(side_picture(), depth); }
vec3 side_position(vec2 side_px, float depth) { return position_in(side_picture(), side_px, depth); }
vec2 side_image_of(vec3 point) { return image_in(side_picture(), point); }

// Whether the camera's picture holds the point's place: it lies behind the near plane and within the edges.
bool is_in_side_picture(vec3 point) {
    if (-point.z <= u_near) return false;
    vec2 side_px = side_image_of(point);
    return side_px == clamp(side_px, vec2(0.0), u_side_size_px);
}

// Four samples of a texel, a fetch. What lies outside of the picture is as for other taps. A side camera's pictures have a
// resolution of their own, whatever that of the G-buffer is.
vec4 side_texel(vec2 side_px, int picture) {
    COUNT_TAP
    vec2 texel = floor(side_px), inside = clamp(texel, vec2(0.0), u_side_size_px - 1.0);
    vec4 depths = texelFetch(u_side_layers, ivec3(inside, picture), 0);
#if BORDER_FAR
    depths = texel == inside ? depths : vec4(u_far);
#endif
    return depths;
}
