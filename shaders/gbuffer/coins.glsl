// Which samples of its texel a fragment gives its depth to. The published generators hash screen coordinates and depth by
// sines; here a fragment is told from others by its pixel, instance and triangle, in integers: they are the same in any
// unit, on any machine and in a mirrored scene, where a depth's last bits are not.
#include "contract/mirror.glsl"
#include "lib/pcg.glsl"

const int kOutputs = (SAMPLES + 3) / 4;
uniform float u_alpha;  // with what probability a sample accepts a surface
uniform uint u_seed;
uniform int u_instance;
uniform int u_first_triangle;

// Seeds must not share numbers: seed ^ sample would only exchange the samples of neighbouring seeds.
uint stream_key(uint stream) { return u_seed * 2654435769u + stream; }

uvec3 fragment_id() {
    uvec2 texel = uvec2(mirrored_texel(ivec2(gl_FragCoord.xy), ivec2(u_size_px)));
    uint triangle = uint(u_first_triangle + gl_PrimitiveID) + uint(u_instance) * 2246822519u;
    return uvec3(texel, triangle);
}

vec4 fragment_numbers(uint stream) { return unit_numbers(pcg4d(uvec4(fragment_id(), stream_key(stream)))); }

// No sample beyond the last one accepts anything.
bvec4 exists(int i) { return lessThan(ivec4(0, 1, 2, 3) + 4 * i, ivec4(SAMPLES)); }

#if defined(SAMPLING_PEELED)
bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    for (int i = 0; i < kOutputs; ++i) accepted[i] = bvec4(true);
    return accepted;
}

#elif defined(SAMPLING_STRATIFIED)
// R = floor(alpha S + xi) of the S samples, every such subset equally likely: drawn once a fragment. As printed, inside the
// loop over samples, each would have a subset of its own, and the method would be the plain coins. By selection in order
// (Fan, Muller and Rezucha, Development of Sampling Plans by Using Sequential Item by Item Selection Techniques, 1962)
// in place of a table of all subsets: R of the left ones, each with its chance.
bvec4[kOutputs] accepted_samples() {
    bvec4 accepted[kOutputs];
    float wanted = min(floor(u_alpha * float(SAMPLES) + fragment_numbers(uint(kOutputs)).x), float(SAMPLES));
    for (int i = 0; i < kOutputs; ++i) {
        accepted[i] = bvec4(false);
        if (wanted == 0.0) continue;
        vec4 number = fragment_numbers(uint(i));
        for (int j = 0; j < min(SAMPLES - 4 * i, 4); ++j) {
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
    begin_thresholds();
    for (int i = 0; i < kOutputs; ++i) {
#if PER_SAMPLE
        vec4 threshold = thresholds(i);
#else
        vec4 threshold = thresholds(0).xxxx;
#endif
        bvec4 is_accepted = lessThan(threshold, vec4(u_alpha)), there = exists(i);
        accepted[i] = bvec4(is_accepted.x && there.x, is_accepted.y && there.y, is_accepted.z && there.z,
                            is_accepted.w && there.w);
    }
    return accepted;
}
#endif
