#include "scene/scene_digest.h"

#include "core/hash.h"

#include <span>

namespace aoscore {
namespace {

template <class T>
std::span<const T> all(const std::vector<T>& values) {
    return values;
}

}  // namespace

std::string scene_digest(const Scene& scene) {
    Digest digest;
    digest.text("scene 1");
    digest.value(scene.origin);
    for (const Material& material : scene.materials) {
        digest.value(material.base_color);
        digest.value(material.alpha_cutoff);
        if (!material.is_cutout() || material.texture < 0) continue;
        const Texture& texture = scene.textures[static_cast<std::size_t>(material.texture)];
        digest.value(texture.wrap_s).value(texture.wrap_t);
        digest.value(texture.texels.width).value(texture.texels.height);
        digest.array(all(texture.texels.pixels));
    }
    digest.value(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) {
        digest.value(mesh.material);
        digest.array(all(mesh.positions)).array(all(mesh.normals)).array(all(mesh.triangles));
        if (scene.materials[static_cast<std::size_t>(mesh.material)].is_cutout())
            digest.array(all(mesh.texcoords));
        if (!mesh.alphas.empty()) digest.text("alphas").array(all(mesh.alphas));
    }
    digest.value(scene.instances.size());
    for (const Instance& instance : scene.instances) {
        digest.value(instance.mesh);
        digest.value(instance.scene_from_mesh);
        if (instance.is_dynamic) digest.text("dynamic");
    }
    return digest.hex();
}

}  // namespace aoscore
