// N8AO: V = (1 - sum of hidden / taps in the picture)^intensity over cosine-distributed directions, each tested at one
// point whose distance is stratified over the radius and shifted in every pixel.
#include "contract/ao_pass.glsl"
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/limits.glsl"
#include "lib/noise.glsl"
#include "lib/spiral.glsl"

const float kFalloffScale = 0.2;

// Tangent, bitangent, n; the bitangent as near to upward as it may be.
mat3 upright_basis(vec3 n) {
    vec3 helper = mirrored(vec3(0.0, 1.0, 0.0));
    if (dot(helper, n) > 0.99) helper = mirrored(vec3(1.0, 0.0, 0.0));
    vec3 tangent = normalize(kHandedness * cross(helper, n));
    return mat3(tangent, kHandedness * cross(n, tangent), n);
}

// Malley's projection of an even disc onto the hemisphere.
vec3 direction(int i, float turn) {
    vec2 p = golden_spiral(i, p_samples, turn);
    return vec3(p, sqrt(max(1.0 - dot(p, p), 0.0)));
}

bool in_frustum(vec2 image_px, float depth) {
    vec2 beyond = step(u_size_px, image_px) + step(image_px, vec2(0.0));
    return beyond == vec2(0.0) && depth > u_near && depth < u_far;
}

float surface_depth(vec2 tap_px, vec2 image_px) {
    vec2 offset = tap_px - image_px;
    float level = floor(0.5 * log2(max(dot(offset, offset), 1.0))) - float(p_full_radius_log2);
    return tap_mip_depth(inside_picture(tap_px), int(clamp(level, 0.0, float(kDepthMipLevels - 1))));
}

// Whether a tap falls into the pixel's own texel or, as its distance is measured from the texel's corner, into one of the
// three to the right and above.
bool in_own_texels(vec2 tap_px) {
    vec2 apart = kMirror * (texel_centre(centre_texel()) - texel_centre(ivec2(floor(tap_px)))) * vec2(1.0, -1.0) + 0.5;
    return dot(apart, apart) < 1.0;
}

// x: how far the surface at the point's place hides it; y: whether there is such a place.
vec2 hidden(vec3 point, vec2 image_px, float own_depth) {
    vec2 tap_px = image_of(point);
    float depth = -point.z;
    float surface = surface_depth(tap_px, image_px), apart = abs(surface - depth);
    bool inside = in_frustum(tap_px, depth);
    bool hides = inside && surface + p_bias <= depth && apart > 0.0 && surface != own_depth && !in_own_texels(tap_px);
    float range = smoothstep(0.0, 1.0, kFalloffScale * p_radius * p_falloff / max(apart, 1e-30));
    return vec2(hides ? range : 0.0, inside ? 1.0 : 0.0);
}

float visibility(vec2 image_px, vec3 position) {
    vec4 noise = pixel_noise();
    vec3 normal =
        p_normal_source == normal_source_from_depth ? centre_normal_from_depth_accurate() : centre_normal_geometric();
    mat3 view_from_tangent = upright_basis(normal);
    vec2 sum = vec2(0.0);
#pragma unroll
    for (int i = 0; i < p_samples; ++i) {
        float part = fract(noise.y + float(i) / float(p_samples));
        vec3 point = position + view_from_tangent * direction(i, -kTwoPi * noise.x) * (part * p_radius);
        sum += hidden(point, image_px, -position.z);
    }
    float open = limited_visibility(1.0 - sum.x / max(sum.y, 1.0));
    return p_intensity == 1.0 ? open : pow(open, p_intensity);
}
