#include "scene/gltf/solid_cutouts.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace aoscore::gltf {
namespace {

float least_alpha(const Scene& scene, const Material& material) {
    std::uint8_t least = 255;
    if (material.texture >= 0) {
        const Texture& texture = scene.textures[static_cast<std::size_t>(material.texture)];
        for (const glm::u8vec4& texel : texture.texels.pixels) least = std::min(least, texel.a);
    }
    return static_cast<float>(least) / 255.0f * material.base_color.a;
}

}  // namespace

void make_uncut_solid(Scene& scene, bool keep_textures) {
    std::vector<float> least_vertex_alpha(scene.materials.size(), 1.0f);
    for (const Mesh& mesh : scene.meshes) {
        float& least = least_vertex_alpha[static_cast<std::size_t>(mesh.material)];
        for (const float alpha : mesh.alphas) least = std::min(least, alpha);
    }
    std::vector<bool> is_uncut(scene.materials.size(), false);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& material = scene.materials[i];
        if (!material.is_cutout()) continue;
        is_uncut[i] = least_alpha(scene, material) * least_vertex_alpha[i] >= material.alpha_cutoff;
        if (!is_uncut[i]) continue;
        material.alpha_cutoff = 0;
        if (!keep_textures) material.texture = -1;
    }
    for (Mesh& mesh : scene.meshes) {
        if (!is_uncut[static_cast<std::size_t>(mesh.material)]) continue;
        mesh.alphas = {};
        if (!keep_textures) mesh.texcoords = {};
    }
}

}  // namespace aoscore::gltf
