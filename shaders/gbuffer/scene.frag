// The G-buffer. What is written is chosen by macros (OUTPUT_…): nothing that no method asks for is computed. A function below gives each channel's value.
#include "surface.glsl"

uniform samplerBuffer u_triangle_normals;  // unit, mesh space
uniform int u_first_triangle;
uniform mat3 u_normal_from_mesh;

in vec3 v_normal;

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
    if (is_passed_over()) discard;
    write_channels();
}
