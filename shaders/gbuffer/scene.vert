// Every triangle of the scene into the G-buffer. The picture is drawn with row 0 at the top (u_clip_from_view turns
// y over), so that gl_FragCoord is the image position of scene/camera.h.
uniform mat4 u_view_from_mesh;  // multiplied in double before it comes here
uniform mat4 u_clip_from_view;
uniform mat3 u_normal_from_mesh;

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
#ifdef CUTOUT
layout(location = 3) in float a_alpha;  // 1 where the scene has none
#endif

#if defined(SAMPLING_ISOTROPIC) || defined(SAMPLING_ANISOTROPIC)
#include "contract/mirror.glsl"
uniform mat4 u_scene_from_view;
out vec3 v_place;  // in scene space: thresholds.glsl takes twice as long where each fragment finds it by itself
#endif

out vec3 v_normal;
out vec2 v_texcoord;
#ifdef CUTOUT
out float v_alpha;
#endif

void main() {
    v_normal = u_normal_from_mesh * a_normal;
    v_texcoord = a_texcoord;
#ifdef CUTOUT
    v_alpha = a_alpha;
#endif
    vec4 view = u_view_from_mesh * vec4(a_position, 1.0);
#if defined(SAMPLING_ISOTROPIC) || defined(SAMPLING_ANISOTROPIC)
    v_place = (u_scene_from_view * vec4(mirrored(view.xyz), 1.0)).xyz;
#endif
    gl_Position = u_clip_from_view * view;
}
