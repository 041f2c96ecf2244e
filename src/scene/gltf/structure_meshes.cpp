#include "scene/gltf/structure.h"

#include <fmt/format.h>

namespace aoscore::gltf {

namespace {

/// TEXCOORD_1 without TEXCOORD_0 is not legal: sets are numbered without gaps.
void check_texcoord_sets(CheckedObject& attributes) {
    int sets = 0;
    attributes.members([&](const std::string& name) { sets += name.starts_with("TEXCOORD_") ? 1 : 0; });
    for (int set = 0; set < sets; ++set) {
        const std::string name = fmt::format("TEXCOORD_{}", set);
        if (!attributes.has(name)) attributes.fail(name, "is missing, higher sets are there");
    }
}

}  // namespace

void check_meshes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings) {
    bool has_targets = false;
    std::vector<bool> has_view;
    root.objects("accessors", [&](CheckedObject& accessor, std::size_t) {
        has_view.push_back(accessor.has("bufferView"));
    });
    root.objects("meshes", [&](CheckedObject& mesh, std::size_t) {
        if (mesh.count("primitives") == 0)
            mesh.fail("primitives", "is missing or empty", "at least one primitive");
        mesh.objects("primitives", [&](CheckedObject& primitive, std::size_t) {
            primitive.integer("mode", 0, 6);
            const auto indices = primitive.index("indices", counts.accessors);
            if (indices && !has_view[*indices]) {
                // Legal for sparse indices over zeros, but nobody writes it and tinygltf refuses it.
                primitive.fail("indices", "its accessor has no bufferView");
            }
            primitive.index("material", counts.materials);
            primitive.required_object("attributes", [&](CheckedObject& attributes) {
                attributes.members(
                    [&](const std::string& name) { attributes.index(name, counts.accessors); });
                check_texcoord_sets(attributes);
            });
            has_targets |= primitive.count("targets") > 0;
            // Not read; tinygltf would trust the indices in them.
            primitive.erase("targets");
        });
    });
    if (has_targets) warnings.push_back("morph targets are not posed: meshes are drawn in their base shape");
}

void check_nodes_and_scenes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings) {
    bool has_skin = false, has_both = false;
    root.objects("nodes", [&](CheckedObject& node, std::size_t) {
        node.indices("children", counts.nodes);
        node.index("mesh", counts.meshes);
        node.index("camera", counts.cameras);
        has_skin |= node.index("skin", counts.skins).has_value();
        const bool has_matrix = !node.numbers("matrix", 16).empty();
        node.numbers("translation", 3);
        node.numbers("rotation", 4);
        node.numbers("scale", 3);
        has_both |= has_matrix && (node.has("translation") || node.has("rotation") || node.has("scale"));
        node.erase("weights");
    });
    if (has_skin)
        warnings.push_back("skins are not posed: skinned meshes are drawn as modelled, at their node");
    if (has_both)
        warnings.push_back("nodes have a matrix and translation, rotation or scale: the matrix counts");

    root.objects("scenes", [&](CheckedObject& scene, std::size_t) { scene.indices("nodes", counts.nodes); });
    root.index("scene", counts.scenes);
}

}  // namespace aoscore::gltf
