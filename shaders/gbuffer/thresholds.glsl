// A number in [0,1) for each sample of a fragment, below which alpha must not lie. Evenly distributed: a sample accepts a
// surface with probability alpha.

void begin_thresholds();
vec4 thresholds(int output_index);  // of the output's four samples

#if defined(SAMPLING_SIMPLE_HASH)
void begin_thresholds() {}
vec4 thresholds(int output_index) { return fragment_numbers(uint(output_index)); }

#elif defined(SAMPLING_HASH_4D)
// hash4D(X, Y, Z, M) = hash(hash(hash(X, Y), Z), M), M the sample.
uint hashed(uint a, uint b) { return pcg4d(uvec4(a, b, 0u, 0u)).x; }
uint fragment_hash = 0u;

void begin_thresholds() {
    uvec3 id = fragment_id();
    fragment_hash = hashed(hashed(id.x, id.y), id.z);
}
vec4 thresholds(int output_index) {
    uint first = stream_key(4u * uint(output_index));
    return unit_numbers(uvec4(hashed(fragment_hash, first), hashed(fragment_hash, first + 1u),
                              hashed(fragment_hash, first + 2u), hashed(fragment_hash, first + 3u)));
}

#else
// Anchored in the scene (Wyman and McGuire, Improved Alpha Testing Using Hashed Sampling, 2017, listings 1 and 2): hashes
// of the place in voxels of about a pixel, at the two nearest powers of two, mixed, and made even again.
uniform mat4 u_scene_from_view;
vec3 voxel_low = vec3(0.0), voxel_high = vec3(0.0);  // numbers of both voxels
float mixing = 0.0;

void begin_thresholds() {
    vec3 view = mirrored(view_position(gl_FragCoord.xy, linear_depth()));
    vec3 place = (u_scene_from_view * vec4(view, 1.0)).xyz;
    vec3 dx = dFdx(place), dy = dFdy(place);
#if defined(SAMPLING_ISOTROPIC)
    vec3 level = vec3(-log2(max(length(dx), length(dy))));
    mixing = fract(level.x);
#else
    // An axis along which nothing changes has no scale: it gets a thousandth of the largest change's.
    vec3 change = max(abs(dx), abs(dy));
    change = max(change, 1e-3 * max(change.x, max(change.y, change.z)));
    vec3 level = log2(0.707 / change);
    float to_low = length(fract(level)), to_high = length(1.0 - fract(level));
    mixing = to_low / (to_low + to_high);
#endif
    voxel_low = floor(exp2(floor(level)) * place) + 0.0;  // no -0
    voxel_high = floor(exp2(ceil(level)) * place) + 0.0;
}

// The distribution function of (1-t) a + t b, a and b even in [0,1).
float evened(float x, float t) {
    float a = min(t, 1.0 - t), b = 1.0 - a;
    if (x < a) return x * x / (2.0 * a * b);
    if (x < b) return (x - 0.5 * a) / b;
    return 1.0 - (1.0 - x) * (1.0 - x) / (2.0 * a * b);
}

float threshold(uint sample_index) {
    uint key = stream_key(sample_index);
    float low = unit_numbers(pcg4d(uvec4(floatBitsToUint(voxel_low), key))).x;
    float high = unit_numbers(pcg4d(uvec4(floatBitsToUint(voxel_high), key))).x;
    return clamp(evened(mix(low, high, mixing), mixing), 1e-6, 0.9999999);
}

vec4 thresholds(int output_index) {
    uint first = 4u * uint(output_index);
    return vec4(threshold(first), threshold(first + 1u), threshold(first + 2u), threshold(first + 3u));
}
#endif
