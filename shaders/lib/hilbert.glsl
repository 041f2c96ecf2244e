// Noise along a space-filling curve: neighbours on the curve get neighbours of a low-discrepancy sequence, so that any
// small square of pixels has it evenly.
#include "contract/inputs.glsl"

// Place of a pixel along a Hilbert curve that fills a tile of 64x64 (Hilbert, Ueber die stetige Abbildung einer Linie auf
// ein Flächenstück, 1891): from the largest quadrants to the smallest, turning the axes as the curve does.
uint hilbert_index(uvec2 pixel) {
    uint index = 0u;
    for (int level = 5; level >= 0; --level) {
        uvec2 quadrant = (pixel >> uint(level)) & 1u;
        index += ((3u * quadrant.x) ^ quadrant.y) << uint(2 * level);
        if (quadrant.y == 0u) {
            if (quadrant.x == 1u) pixel = 63u - (pixel & 63u);
            pixel = pixel.yx;
        }
    }
    return index;
}

// Two numbers in [0,1): the R2 sequence (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018) along
// the curve. Other seeds begin farther along it.
vec2 hilbert_noise() {
    float index = float(hilbert_index(uvec2(noise_texel()) & 63u) + 288u * ((u_seed - 1u) & 63u));
    return fract(0.5 + index * vec2(0.75487766624669276, 0.56984029099805327));
}
