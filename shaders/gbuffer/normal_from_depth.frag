// View-space normals from depth alone, turned to the camera.
#include "contract/view.glsl"

uniform sampler2D u_linear_depth;

layout(location = 0) out vec4 o_normal;

float depth_at(ivec2 texel) { return texelFetch(u_linear_depth, clamp(texel, ivec2(0), ivec2(u_size_px) - 1), 0).r; }

vec3 position_at(ivec2 texel) {
    ivec2 inside = clamp(texel, ivec2(0), ivec2(u_size_px) - 1);
    return view_position(vec2(inside) + 0.5, depth_at(inside));
}

#if ACCURATE
// 1/depth (perspective) or depth (orthographic) is linear over a plane in the picture.
float planar(float depth) {
#if ORTHOGRAPHIC
    return depth;
#else
    return 1.0 / depth;
#endif
}

// The derivative along `step` from the side whose two pixels extrapolate to the centre's depth (Wu, Accurate Normal
// Reconstruction from Depth Buffer, 2019).
vec3 difference(ivec2 texel, ivec2 step, vec3 centre) {
    float here = planar(-centre.z);
    float ahead = abs(2.0 * planar(depth_at(texel + step)) - planar(depth_at(texel + 2 * step)) - here);
    float behind = abs(2.0 * planar(depth_at(texel - step)) - planar(depth_at(texel - 2 * step)) - here);
    // Beyond the edge of the picture there is nothing to extrapolate from.
    ivec2 two_ahead = texel + 2 * step, two_behind = texel - 2 * step;
    if (any(greaterThanEqual(two_ahead, ivec2(u_size_px)))) ahead = 1e30;
    if (any(lessThan(two_behind, ivec2(0)))) behind = 1e30;
    return ahead < behind ? position_at(texel + step) - centre : centre - position_at(texel - step);
}
#else
vec3 difference(ivec2 texel, ivec2 step, vec3 centre) {
    ivec2 ahead = texel + step;
    bool inside = all(lessThan(ahead, ivec2(u_size_px)));
    return inside ? position_at(ahead) - centre : centre - position_at(texel - step);
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 centre = position_at(texel);
    vec3 n = cross(difference(texel, ivec2(1, 0), centre), difference(texel, ivec2(0, 1), centre));
    float length_squared = dot(n, n);
    vec3 ray = view_ray(gl_FragCoord.xy);
    // A picture one pixel wide has no derivative: the surface faces the camera.
    n = length_squared > 0.0 ? n * inversesqrt(length_squared) : vec3(0.0, 0.0, 1.0);
    o_normal = vec4(dot(n, ray) > 0.0 ? -n : n, 0.0);
}
