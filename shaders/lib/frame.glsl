// Orthonormal bases and rotations, for what is random: the run may mirror them.
#include "contract/mirror.glsl"

// Turns a kernel's point into a direction of the picture.
mat2 rotation(float angle) {
    float c = cos(angle), s = sin(angle);
    return mat2(mirrored(vec2(c, s)), mirrored(vec2(-s, c)));
}

// Columns tangent, bitangent, n (unit), the tangent along the part of `toward` that is perpendicular to n; any
// tangent where there is none.
mat3 basis_toward(vec3 n, vec3 toward) {
    toward = mirrored(toward);
    vec3 tangent = toward - n * dot(toward, n);
    float length_squared = dot(tangent, tangent);
    if (length_squared < 1e-12) {
        tangent = mirrored(abs(n.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
        tangent -= n * dot(tangent, n);
        length_squared = dot(tangent, tangent);
    }
    tangent *= inversesqrt(length_squared);
    return mat3(tangent, kHandedness * cross(n, tangent), n);
}
