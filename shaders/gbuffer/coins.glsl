// Which samples of its texel a fragment gives its depth to. The published generators hash screen coordinates and depth by
// sines; here a fragment is told from others by its pixel, instance and triangle, in integers: they are the same in any
// unit, on any machine and in a mirrored scene, where a depth's last bits are not.
#include "contract/mirror.glsl"
#include "lib/pcg.glsl"

const int kOutputs = (SAMPLES + 3) / 4;
// One hash serves eight samples: each has sixteen bits, so that a probability is one of this many, rounded up.
const float kProbabilities = 65536.0;
uniform float u_alpha;  // with what probability a sample accepts a surface
uniform uint u_seed;

uint triangle_id();  // of the surface whose coins these are

// Seeds must not share numbers: seed ^ sample would only exchange the samples of neighbouring seeds.
uint stream_key(int stream) { return u_seed * 2654435769u + uint(stream); }

uvec3 fragment_id() {
    uvec2 texel = uvec2(mirrored_texel(ivec2(gl_FragCoord.xy), ivec2(u_size_px)));
    return uvec3(texel, triangle_id());
}

// Four numbers in [0,1), even and independent.
vec4 upper_numbers(uvec4 bits) { return vec4(ivec4(bits >> 16u)) / kProbabilities; }
vec4 lower_numbers(uvec4 bits) { return vec4(ivec4(bits & 65535u)) / kProbabilities; }

// Those of an output's samples, of what is at this place.
vec4 numbers_at(uvec3 place, int output_index) {
    uvec4 bits = pcg4d(uvec4(place, stream_key(output_index / 2)));
    return output_index % 2 == 0 ? upper_numbers(bits) : lower_numbers(bits);
}

#if defined(SAMPLING_PEELED)
bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    for (int i = 0; i < kOutputs; ++i) accepted[i] = bvec4(true);
    return accepted;
}

#elif defined(SAMPLING_STATIC_AND_DYNAMIC)
// The first sample takes what stands still, the second what moves.
uniform int u_is_dynamic;

bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    for (int i = 0; i < kOutputs; ++i) accepted[i] = bvec4(false);
    accepted[0].xy = bvec2(u_is_dynamic == 0, u_is_dynamic != 0);
    return accepted;
}

#elif defined(SAMPLING_STRATIFIED)
// R = floor(alpha S + xi) of the S samples, every such subset equally likely: drawn once a fragment. As printed, inside the
// loop over samples, each would have a subset of its own, and the method would be the plain coins. By selection in order
// (Fan, Muller and Rezucha, Development of Sampling Plans by Using Sequential Item by Item Selection Techniques, 1962)
// in place of a table of all subsets: R of the left ones, each with its chance. The last one left needs no number, since
// it is wanted or not: xi has its bits, which end those of the last hash.
bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    float xi = numbers_at(fragment_id(), (kOutputs - 1) | 1).w;
    float wanted = floor(u_alpha * float(SAMPLES) + xi);
    for (int i = 0; i < kOutputs; ++i) {
        vec4 number = numbers_at(fragment_id(), i);
        for (int j = 0; j < 4; ++j) {
            accepted[i][j] = number[j] * float(SAMPLES - 4 * i - j) < wanted;
            wanted -= accepted[i][j] ? 1.0 : 0.0;
        }
    }
    return accepted;
}

#else
#include "thresholds.glsl"

bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    float threshold = threshold_of_alpha();
    for (int i = 0; i < kOutputs; ++i) {
#if PER_SAMPLE
        accepted[i] = lessThan(numbers(i), vec4(threshold));
#else
        accepted[i] = bvec4(numbers(0).x < threshold);
#endif
    }
    return accepted;
}
#endif
