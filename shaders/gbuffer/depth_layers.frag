// Depth layers: SAMPLES view depths a texel, four in each output. A surface is written where a sample accepts it and the
// far plane's depth elsewhere; blending by the minimum leaves the nearest accepted one. Peeled layers accept every surface.
// Vermeer, Stochastic-Depth Ambient Occlusion, 2020, algorithms 4 and 5, section 8.2.
#include "surface.glsl"
#include "coins.glsl"

layout(location = 0) out vec4 o_depths[kOutputs];

void main() {
    bvec4 accepted[kOutputs] = accepted_samples();
    bool any_accepted = false;
    for (int i = 0; i < kOutputs; ++i) any_accepted = any_accepted || any(accepted[i]);
    if (!any_accepted || is_passed_over()) discard;
    float depth = linear_depth();
    for (int i = 0; i < kOutputs; ++i) o_depths[i] = mix(vec4(u_far), vec4(depth), accepted[i]);
}
