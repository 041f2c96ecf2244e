// A number for each sample of a fragment, and what it must be less than for the sample to accept the surface, which it is
// with probability alpha.

float threshold_of_alpha();
vec4 numbers(int output_index);  // of the output's four samples; threshold_of_alpha() comes first

#if defined(SAMPLING_SIMPLE_HASH)
float threshold_of_alpha() { return u_alpha; }
vec4 numbers(int output_index) { return numbers_at(fragment_id(), output_index); }

#elif defined(SAMPLING_HASH_4D)
// hash4D(X, Y, Z, M) = hash(hash(hash(X, Y), Z), M); M is the sample there, and here an output: four samples share the
// bits of a hash.
uint fragment_hash = 0u;

float threshold_of_alpha() {
    uvec3 id = fragment_id();
    fragment_hash = pcg2d(uvec2(pcg2d(id.xy).x, id.z)).x;
    return u_alpha;
}
vec4 numbers(int output_index) {
    uvec2 bits = pcg2d(uvec2(fragment_hash, stream_key(output_index)));
    return vec4(upper_numbers(bits.xyxy).xy, lower_numbers(bits.xyxy).xy);
}

#else
// Anchored in the scene (Wyman and McGuire, Improved Alpha Testing Using Hashed Sampling, 2017, listings 1 and 2): hashes
// of the place in voxels of about a pixel, at the two nearest powers of two, mixed. The paper makes every mixed number even
// by its distribution function, and compares with alpha; here alpha goes through the inverse, once a fragment.
in vec3 v_place;  // in scene space
uvec3 voxel_low = uvec3(0u), voxel_high = uvec3(0u);
float mixing = 0.0;
const float kLeastChange = 1e-18;  // metres from pixel to pixel, where floats see none

// Below what (1-t) a + t b lies with this probability, a and b even in [0,1).
float quantile(float probability, float t) {
    float a = min(t, 1.0 - t), b = 1.0 - a;
    float least = 0.5 * a / b;  // the probability of less than a, or of more than b
    float tail = sqrt(2.0 * a * b * min(probability, 1.0 - probability));
    return probability < least ? tail : 1.0 - probability < least ? 1.0 - tail : probability * b + 0.5 * a;
}

// Of positive numbers, in steps of 2^-23: a float's bits are its binary logarithm, straight from power to power of two. The
// paper's is the true one, which moves the mixing by .04 at most, and no probability.
const int kOctave = 1 << 23, kLogarithmOfOne = 127 * kOctave;
int logarithm(float x) { return floatBitsToInt(x) - kLogarithmOfOne; }
ivec3 logarithm(vec3 x) { return floatBitsToInt(x) - kLogarithmOfOne; }
float power_of_two_below(int logarithm) { return intBitsToFloat((logarithm & -kOctave) + kLogarithmOfOne); }
vec3 power_of_two_below(ivec3 logarithm) { return intBitsToFloat((logarithm & -kOctave) + kLogarithmOfOne); }

float threshold_of_alpha() {
    vec3 dx = dFdx(v_place), dy = dFdy(v_place);
#if defined(SAMPLING_ISOTROPIC)
    // Of 1 / the change: half of its square's.
    int scale = -logarithm(max(max(dot(dx, dx), dot(dy, dy)), kLeastChange * kLeastChange)) >> 1;
    float low = power_of_two_below(scale);
    mixing = float(scale & (kOctave - 1)) / float(kOctave);
#else
    // An axis along which nothing changes has no scale: it gets a thousandth of the largest change's.
    vec3 change = max(abs(dx), abs(dy));
    change = max(change, max(1e-3 * max(change.x, max(change.y, change.z)), kLeastChange));
    ivec3 scale = logarithm(0.707) - logarithm(change);
    vec3 low = power_of_two_below(scale), above = vec3(scale & (kOctave - 1)) / float(kOctave);
    float to_low = length(above), to_high = length(1.0 - above);
    mixing = to_low / (to_low + to_high);
#endif
    voxel_low = floatBitsToUint(floor(low * v_place) + 0.0);  // no -0
    voxel_high = floatBitsToUint(floor(2.0 * low * v_place) + 0.0);
    return quantile(u_alpha, mixing);
}

vec4 numbers(int output_index) {
    return mix(numbers_at(voxel_low, output_index), numbers_at(voxel_high, output_index), mixing);
}
#endif
