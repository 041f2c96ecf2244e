// Depth layers: SAMPLES view depths a texel, four in each output. A surface is written where a sample accepts it and the
// far plane's depth elsewhere; blending by the minimum leaves the nearest accepted one. Peeled layers accept every surface.
// Samples beyond the last one hold anything, and are never read.
// Vermeer, Stochastic-Depth Ambient Occlusion, 2020, algorithms 4 and 5, section 8.2.
#include "surface.glsl"
#include "coins.glsl"
#include "triangle_id.glsl"
#ifdef FACING
#include "facing.glsl"
#endif

layout(location = 0) out vec4 o_depths[kOutputs];

void main() {
    bvec4 accepted[kOutputs] = accepted_samples();
    float depth = linear_depth();
#ifdef FACING
    depth = is_front() ? depth : -depth;
#endif
    if (is_passed_over()) {
#if defined(SAMPLING_PEELED)
        discard;  // its depth must not be stored
#else
        depth = u_far;  // changes no minimum, and costs llvmpipe half of what a discard does
#endif
    }
    for (int i = 0; i < kOutputs; ++i) o_depths[i] = mix(vec4(u_far), vec4(depth), accepted[i]);
}
