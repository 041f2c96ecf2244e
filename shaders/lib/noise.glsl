// Per-pixel random numbers. The method declares the choice parameter `noise` with tiled_4x4, hash,
// interleaved_gradient and none, in any order, and lists the input noise_4x4.
#include "contract/inputs.glsl"
#include "lib/pcg.glsl"

vec4 hash_noise(ivec2 texel, uint stream) {
    return unit_numbers(pcg4d(uvec4(uvec2(texel), u_seed, stream)));
}

// Jimenez, Next Generation Post Processing in Call of Duty: Advanced Warfare, 2014; later channels and other seeds are
// the same pattern moved.
float interleaved_gradient(vec2 at) { return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))); }

vec4 interleaved_gradient_noise(ivec2 texel) {
    vec2 at = vec2(texel) + 5.588238 * float(u_seed & 63u);
    return vec4(interleaved_gradient(at), interleaved_gradient(at + vec2(47.0, 17.0)),
                interleaved_gradient(at + vec2(11.0, 83.0)), interleaved_gradient(at + vec2(71.0, 5.0)));
}

// Four numbers in [0,1) for this pixel; none: the same for all pixels, to see what the randomness is worth.
vec4 pixel_noise() {
    if (p_noise == noise_none) return vec4(0.75, 0.5, 0.25, 0.5);
    if (p_noise == noise_hash) return hash_noise(noise_texel(), 0u);
    if (p_noise == noise_interleaved_gradient) return interleaved_gradient_noise(noise_texel());
    return tiled_noise();
}
