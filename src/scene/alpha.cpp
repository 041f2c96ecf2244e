#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

// The GLSL twin in shaders/contract/ does the same steps in the same order, in float32:
//
//   u := 0 where it is not finite
//   repeat:          t = u - floor(u)
//   mirrored_repeat: t = u - 2 floor(u / 2); t = 2 - t where t > 1
//   clamp_to_edge:   t = min(max(u, 0), 1)
//   x = t * size - 0.5;  i = floor(x);  f = x - i        so i is in [-1, size - 1]
//   texels i and i + 1, brought back into [0, size - 1]: repeat adds or subtracts size once, the others clamp
//   (a mirrored texel beyond the edge is the edge texel itself)
//   per row a + (b - a) * f along u, the two rows likewise along v, over bytes 0 to 255; then / 255, times
//   factor, times the vertices' alpha
struct Tap {
    int first;
    int second;
    float fraction;
};

int into_range(int i, int size, Texture::Wrap wrap) {
    if (wrap == Texture::Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
    return std::clamp(i, 0, size - 1);
}

Tap tap_at(float u, int size, Texture::Wrap wrap) {
    if (!std::isfinite(u)) u = 0;
    float t = 0;
    switch (wrap) {
        case Texture::Wrap::repeat:
            t = u - std::floor(u);
            break;
        case Texture::Wrap::mirrored_repeat:
            t = u - 2.0f * std::floor(u / 2.0f);
            if (t > 1.0f) t = 2.0f - t;
            break;
        case Texture::Wrap::clamp_to_edge:
            t = std::min(std::max(u, 0.0f), 1.0f);
            break;
    }
    const float x = t * static_cast<float>(size) - 0.5f;
    const float floor_x = std::floor(x);
    const int i = static_cast<int>(floor_x);
    return {into_range(i, size, wrap), into_range(i + 1, size, wrap), x - floor_x};
}

float mix(float a, float b, float f) {
    return a + (b - a) * f;
}

}  // namespace

float alpha_at(const Scene& scene, const Material& material, const glm::vec2& uv, float vertex_alpha) {
    if (material.texture < 0) return material.base_color.a * vertex_alpha;
    const Texture& texture = scene.textures[static_cast<std::size_t>(material.texture)];
    const Tap s = tap_at(uv.x, texture.texels.width, texture.wrap_s);
    const Tap t = tap_at(uv.y, texture.texels.height, texture.wrap_t);
    const auto alpha = [&](int x, int y) { return static_cast<float>(texture.texels.at(x, y).a); };
    const float top = mix(alpha(s.first, t.first), alpha(s.second, t.first), s.fraction);
    const float bottom = mix(alpha(s.first, t.second), alpha(s.second, t.second), s.fraction);
    return mix(top, bottom, t.fraction) / 255.0f * material.base_color.a * vertex_alpha;
}

}  // namespace aoscore
