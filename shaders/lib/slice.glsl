// Slices of the hemisphere that contain the view vector (Jimenez et al., Practical Real-Time Strategies for Accurate
// Indirect Occlusion, 2016). Angles in a slice are measured from the view vector, positive along `along`.
#include "contract/inputs.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/horizon.glsl"

// Unit, from the surface to the viewer.
vec3 view_vector(vec3 position) {
#if ORTHOGRAPHIC
    return vec3(0.0, 0.0, 1.0);
#else
    return normalize(-position);
#endif
}

struct ViewSlice {
    vec3 view;             // unit, to the viewer
    vec3 along;            // unit, perpendicular to view, in the slice
    vec2 image_px;         // where a metre along `along` leads in the picture
    vec3 across, measure;  // move a tap into the slice, as lib/horizon.glsl's Slice does
    float normal_length;   // |n_p|, of the normal's part in the slice
    float normal_angle;    // γ, of that part
};

// With view, along and image_px given.
ViewSlice completed(ViewSlice slice, vec3 normal, vec3 line_of_sight) {
    vec3 slice_normal = cross(slice.along, slice.view);
    vec2 direction = normalize(slice.image_px);
    slice.across = slice_tangent(vec2(-direction.y, direction.x), normal, line_of_sight);
    slice.measure = slice_normal / dot(slice.across, slice_normal);

    vec3 in_slice = normal - slice_normal * dot(normal, slice_normal);
    slice.normal_length = length(in_slice);
    slice.normal_angle = atan(dot(in_slice, slice.along), dot(in_slice, slice.view));
    return slice;
}

// The slice at this azimuth about the view vector. Azimuths are even about it, not in the picture, so that the mean
// over slices is that over the hemisphere away from the picture's centre too.
ViewSlice view_slice(float azimuth, vec3 position, vec3 normal, vec3 line_of_sight) {
    ViewSlice slice;
    slice.view = view_vector(position);
    mat3 basis = basis_toward(slice.view, vec3(1.0, 0.0, 0.0));
    slice.along = basis[0] * cos(azimuth) + basis[1] * sin(azimuth);
#if ORTHOGRAPHIC
    vec2 motion = slice.along.xy;
#else
    vec2 motion = (slice.along.xy * -position.z + position.xy * slice.along.z) / (position.z * position.z);
#endif
    slice.image_px = motion / vec2(u_pixel_size.x, -u_pixel_size.y);
    return completed(slice, normal, line_of_sight);
}

// The slice at this azimuth in the picture; a metre along it is the face-on projection.
ViewSlice screen_slice(float azimuth, vec3 position, vec3 normal, vec3 line_of_sight) {
    ViewSlice slice;
    slice.view = view_vector(position);
    vec2 direction = mirrored(vec2(cos(azimuth), sin(azimuth)));
    vec3 along = view_of_image_direction(direction);
    slice.along = normalize(along - slice.view * dot(along, slice.view));
    slice.image_px = direction * pixels_per_metre(-position.z);
    return completed(slice, normal, line_of_sight);
}

vec3 into_slice(vec3 v, ViewSlice slice) { return v - slice.across * dot(v, slice.measure); }

// Angle in the slice of a vector on one side (+1 along, -1 against), from the view vector.
float slice_angle(vec3 v, ViewSlice slice) {
    return acos(clamp(dot(v, slice.view) * inversesqrt(dot(v, v)), -1.0, 1.0));
}

// ∫_0^h cos(θ-γ) sin θ dθ for a horizon h on either side: its part of a slice's visibility over |n_p|.
float slice_arc(float horizon, float gamma) {
    return 0.25 * (cos(gamma) + 2.0 * horizon * sin(gamma) - cos(2.0 * horizon - gamma));
}
