// The four smaller pictures joined: a pixel's own value and, bilinear and pushed away from edges, those of the pictures
// beside, above and across.
#include "filters/cacao-blur/edges.glsl"

// Of the smaller picture that begins at pixel `first`, at a place in its own pixels.
float bilinear_of(ivec2 first, vec2 at) {
    vec2 corner = floor(at - 0.5), fraction = at - 0.5 - corner;
    ivec2 texel = kInterleaved * ivec2(corner) + first;
    float above = mix(tap_visibility(texel), tap_visibility(texel + ivec2(kInterleaved, 0)), fraction.x);
    texel.y += kInterleaved;
    float below = mix(tap_visibility(texel), tap_visibility(texel + ivec2(kInterleaved, 0)), fraction.x);
    return mix(above, below, fraction.y);
}

float filtered(ivec2 texel) {
    vec4 open = stored_open(texel);
    ivec2 own = texel & 1, other = 1 - own;
    vec2 at = vec2(texel), toward = vec2(own) - 0.5, away = vec2(open.y - open.x, open.w - open.z);
    float beside = bilinear_of(ivec2(other.x, own.y), 0.5 * (at + vec2(toward.x + away.x, -toward.y)));
    float above = bilinear_of(ivec2(own.x, other.y), 0.5 * (at + vec2(-toward.x, toward.y + away.y)));
    float across = bilinear_of(other, 0.5 * (at + toward + away));
    float by_side = 0.5 * (open.x + open.y), by_above = 0.5 * (open.z + open.w), by_corner = 0.5 * (by_side + by_above);
    float sum = tap_visibility(texel) + by_side * beside + by_above * above + by_corner * across;
    return sum / (1.0 + by_side + by_above + by_corner);
}
