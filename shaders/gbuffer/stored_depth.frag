// Linear depth as a depth buffer gives it back. STORED is one of the formats below: the stored number, and the view depth
// that a shader makes of it in 32-bit floats. A surface stays a surface, however far its depth is rounded.
#include "contract/view.glsl"

uniform sampler2D u_linear_depth;
uniform sampler2D u_hardware_depth;  // window depth, as the rasteriser left it in 32-bit floats

layout(location = 0) out vec4 o_stored;  // depth; where positions are stored, x and y after it

float depth_of_window(float z) {
#if ORTHOGRAPHIC
    return mix(u_near, u_far, z);
#else
    return u_near * u_far / (u_far - z * (u_far - u_near));
#endif
}

// With the window depth turned round, 1 at the near plane: floats are densest where it stores the far half of the scene.
float reversed_window(float depth) {
#if ORTHOGRAPHIC
    return (u_far - depth) / (u_far - u_near);
#else
    return u_near * (u_far - depth) / (depth * (u_far - u_near));
#endif
}
float depth_of_reversed(float z) {
#if ORTHOGRAPHIC
    return mix(u_far, u_near, z);
#else
    return u_near * u_far / (u_near + z * (u_far - u_near));
#endif
}

float rounded(float v, float steps) { return floor(clamp(v, 0.0, 1.0) * steps + 0.5) / steps; }

// 16 bits in two channels of 8 (Gravås, Image-space Ambient Obscurance in WebGL, 2013, section 3.1.2 and appendix A). As
// published the far plane would wrap to the near one.
float packed_in_two_bytes(float d) {
    vec2 digits = fract(vec2(1.0, 255.0) * min(d, 65534.0 / 65535.0));
    digits -= vec2(digits.y / 255.0, 0.0);
    digits = floor(clamp(digits, 0.0, 1.0) * 255.0 + 0.5) / 255.0;
    return digits.x + digits.y / 255.0;
}

float stored(float depth, float window) {
    float linear = clamp((depth - u_near) / (u_far - u_near), 0.0, 1.0);
#if STORED == WINDOW_FLOAT
    return depth_of_window(window);
#elif STORED == WINDOW_24
    return depth_of_window(rounded(window, 16777215.0));
#elif STORED == WINDOW_16
    return depth_of_window(rounded(window, 65535.0));
#elif STORED == REVERSED_FLOAT
    return depth_of_reversed(reversed_window(depth));
#elif STORED == LINEAR_16
    return mix(u_near, u_far, rounded(linear, 65535.0));
#elif STORED == LINEAR_16_300M
    return 300.0 * rounded(depth / 300.0, 65535.0);
#elif STORED == LINEAR_TWO_BYTES
    return mix(u_near, u_far, packed_in_two_bytes(linear));
#elif STORED == POSITION
    return depth;
#endif
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(u_linear_depth, texel, 0).r;
    float window = texelFetch(u_hardware_depth, texel, 0).r;
    float linear = is_background(depth) ? u_far : clamp(stored(depth, window), u_near, u_far * (1.0 - 2e-7));
    o_stored = vec4(linear, view_position(vec2(texel) + 0.5, linear).xy, 0.0);
}
