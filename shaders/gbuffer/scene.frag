// The G-buffer. What is written is chosen by macros (OUTPUT_…), CUTOUT adds the alpha test: nothing that no method
// asks for is computed.
#include "contract/view.glsl"
#include "contract/alpha.glsl"

uniform samplerBuffer u_triangle_normals;  // unit, mesh space
uniform int u_first_triangle;
uniform mat3 u_normal_from_mesh;
uniform float u_alpha_cutoff;

in vec3 v_normal;
in vec2 v_texcoord;
#ifdef CUTOUT
in float v_alpha;
#endif

layout(location = 0) out float o_linear_depth;
#ifdef OUTPUT_NORMAL_GEOMETRIC
layout(location = OUTPUT_NORMAL_GEOMETRIC) out vec4 o_normal_geometric;
#endif
#ifdef OUTPUT_NORMAL_SMOOTH
layout(location = OUTPUT_NORMAL_SMOOTH) out vec4 o_normal_smooth;
#endif
#ifdef OUTPUT_ALBEDO
layout(location = OUTPUT_ALBEDO) out vec4 o_albedo;
#endif

// Turned to the camera: no surface has a back.
vec3 geometric_normal(vec3 view_ray) {
    vec3 n = normalize(u_normal_from_mesh * texelFetch(u_triangle_normals, u_first_triangle + gl_PrimitiveID).xyz);
    return dot(n, view_ray) > 0.0 ? -n : n;
}

void main() {
#ifdef CUTOUT
    if (alpha_at(v_texcoord, v_alpha) < u_alpha_cutoff) discard;
#endif
#if ORTHOGRAPHIC
    float depth = u_near + gl_FragCoord.z * (u_far - u_near);
#else
    float depth = 1.0 / gl_FragCoord.w;
#endif
    // The far plane's depth marks the background.
    o_linear_depth = min(depth, u_far * (1.0 - 2e-7));

#if defined(OUTPUT_NORMAL_GEOMETRIC) || defined(OUTPUT_NORMAL_SMOOTH)
    vec3 geometric = geometric_normal(view_ray(gl_FragCoord.xy));
#endif
#ifdef OUTPUT_NORMAL_GEOMETRIC
    o_normal_geometric = vec4(geometric, 0.0);
#endif
#ifdef OUTPUT_NORMAL_SMOOTH
    float length_squared = dot(v_normal, v_normal);
    vec3 smooth_normal = length_squared > 0.0 ? v_normal * inversesqrt(length_squared) : geometric;
    o_normal_smooth = vec4(dot(smooth_normal, geometric) < 0.0 ? -smooth_normal : smooth_normal, 0.0);
#endif
#ifdef OUTPUT_ALBEDO
    o_albedo = vec4(albedo_at(v_texcoord), 1.0);
#endif
}
