// A method's result at lower resolution, brought up to the picture's.
#include "lib/upsample.glsl"

layout(location = 0) out float o_visibility;

void main() {
    if (is_background(centre_linear_depth())) discard;
    o_visibility = upsampled_visibility();
}
