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
uniform mat4 u_scene_from_view;
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

// The greatest power of two that is not above a positive number: its exponent alone.
vec3 power_of_two(vec3 x) { return uintBitsToFloat(floatBitsToUint(x) & 0x7f800000u); }

float threshold_of_alpha() {
    vec3 view = mirrored(view_position(gl_FragCoord.xy, linear_depth()));
    vec3 place = (u_scene_from_view * vec4(view, 1.0)).xyz;
    vec3 dx = dFdx(place), dy = dFdy(place);
#if defined(SAMPLING_ISOTROPIC)
    vec3 scale = vec3(inversesqrt(max(max(dot(dx, dx), dot(dy, dy)), kLeastChange * kLeastChange)));
    vec3 low = power_of_two(scale);
    mixing = log2(scale.x / low.x);
#else
    // An axis along which nothing changes has no scale: it gets a thousandth of the largest change's.
    vec3 change = max(abs(dx), abs(dy));
    change = max(change, max(1e-3 * max(change.x, max(change.y, change.z)), kLeastChange));
    vec3 scale = 0.707 / change, low = power_of_two(scale), above = log2(scale / low);
    float to_low = length(above), to_high = length(1.0 - above);
    mixing = to_low / (to_low + to_high);
#endif
    voxel_low = floatBitsToUint(floor(low * place) + 0.0);  // no -0
    voxel_high = floatBitsToUint(floor(2.0 * low * place) + 0.0);
    return quantile(u_alpha, mixing);
}

vec4 numbers(int output_index) {
    return mix(numbers_at(voxel_low, output_index), numbers_at(voxel_high, output_index), mixing);
}
#endif
