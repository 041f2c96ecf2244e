// The G-buffer. What is written is chosen by macros (OUTPUT_…), CUTOUT adds the alpha test: nothing that no method
// asks for is computed. A function below gives each channel's value.
#include "contract/view.glsl"
#include "contract/alpha.glsl"

uniform samplerBuffer u_triangle_normals;  // unit, mesh space
uniform int u_first_triangle;
uniform mat3 u_normal_from_mesh;
uniform float u_alpha_cutoff;
#ifdef PEELED
uniform sampler2D u_layer_before;  // window depth of the layer in front of this one
#endif

in vec3 v_normal;
in vec2 v_texcoord;
#ifdef CUTOUT
in float v_alpha;
#endif

// The far plane's depth marks the background.
float linear_depth() {
#if ORTHOGRAPHIC
    float depth = u_near + gl_FragCoord.z * (u_far - u_near);
#else
    float depth = 1.0 / gl_FragCoord.w;
#endif
    return min(depth, u_far * (1.0 - 2e-7));
}

// Turned to the camera: no surface has a back.
vec3 geometric_normal() {
    vec3 n = normalize(u_normal_from_mesh * texelFetch(u_triangle_normals, u_first_triangle + gl_PrimitiveID).xyz);
    return dot(n, view_ray(gl_FragCoord.xy)) > 0.0 ? -n : n;
}

vec3 smooth_normal() {
    vec3 geometric = geometric_normal();
    float length_squared = dot(v_normal, v_normal);
    vec3 n = length_squared > 0.0 ? v_normal * inversesqrt(length_squared) : geometric;
    return dot(n, geometric) < 0.0 ? -n : n;
}

#include "gbuffer/outputs.glsl"  // generated from the table of src/image/channels.cpp

void main() {
#ifdef PEELED
    if (gl_FragCoord.z <= texelFetch(u_layer_before, ivec2(gl_FragCoord.xy), 0).r) discard;
#endif
#ifdef CUTOUT
    if (alpha_at(v_texcoord, v_alpha) < u_alpha_cutoff) discard;
#endif
    write_channels();
}
