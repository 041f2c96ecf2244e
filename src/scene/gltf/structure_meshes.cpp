#include "scene/gltf/structure.h"

#include <fmt/format.h>

namespace aoscore::gltf {

namespace {

/// Whether TEXCOORD_1 lacks TEXCOORD_0, which is not legal: sets are numbered without gaps.
bool has_texcoord_gap(CheckedObject& attributes) {
    int sets = 0;
    attributes.members([&](const std::string& name) { sets += name.starts_with("TEXCOORD_") ? 1 : 0; });
    for (int set = 0; set < sets; ++set) {
        if (!attributes.has(fmt::format("TEXCOORD_{}", set))) return true;
    }
    return false;
}

/// Checks the accessors of attributes.
void check_attributes(CheckedObject& attributes, const Counts& counts) {
    attributes.members([&](const std::string& name) { attributes.index(name, counts.accessors); });
}

void check_draco(CheckedObject& draco, const Counts& counts) {
    draco.required_index("bufferView", counts.buffer_views);
    draco.required_object("attributes", [](CheckedObject& attributes) {
        constexpr std::int64_t kMaxId = 0x7FFFFFFF;
        attributes.members([&](const std::string& name) { attributes.integer(name, 0, kMaxId); });
    });
}

/// Oddities of a mesh's primitives that get a warning.
struct MeshOddities {
    bool texcoord_gap = false, no_primitives = false;
};

void check_primitive(CheckedObject& primitive, const Counts& counts, const std::vector<bool>& has_view,
                     MeshOddities& oddities) {
    primitive.integer("mode", 0, 6);
    bool has_draco = false;
    primitive.object("extensions", [&](CheckedObject& extensions) {
        extensions.object("KHR_draco_mesh_compression", [&](CheckedObject& draco) {
            check_draco(draco, counts);
            has_draco = true;
        });
    });
    const auto indices = primitive.index("indices", counts.accessors);
    // Draco's stream holds the triangles.
    if (has_draco) primitive.erase("indices");
    if (indices && !has_draco && !has_view[*indices]) {
        // Legal for sparse indices over zeros, but nobody writes it and tinygltf refuses it.
        primitive.fail("indices", "its accessor has no bufferView");
    }
    primitive.index("material", counts.materials);
    primitive.required_object("attributes", [&](CheckedObject& attributes) {
        check_attributes(attributes, counts);
        oddities.texcoord_gap |= has_texcoord_gap(attributes);
    });
    primitive.objects("targets",
                      [&](CheckedObject& attributes, std::size_t) { check_attributes(attributes, counts); });
}

void check_skins(CheckedObject& root, const Counts& counts) {
    root.objects("skins", [&](CheckedObject& skin, std::size_t) {
        if (skin.indices("joints", counts.nodes).empty())
            skin.fail("joints", "is missing or empty", "at least one node");
        skin.index("inverseBindMatrices", counts.accessors);
        skin.index("skeleton", counts.nodes);
    });
}

void check_node_extensions(CheckedObject& extensions, const Counts& counts) {
    extensions.object("KHR_node_visibility",
                      [](CheckedObject& visibility) { visibility.boolean("visible"); });
    extensions.object("EXT_mesh_gpu_instancing", [&](CheckedObject& instancing) {
        instancing.object("attributes",
                          [&](CheckedObject& attributes) { check_attributes(attributes, counts); });
    });
}

}  // namespace

void check_meshes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings) {
    std::vector<bool> has_view;
    root.objects("accessors", [&](CheckedObject& accessor, std::size_t) {
        has_view.push_back(accessor.has("bufferView"));
    });
    MeshOddities oddities;
    root.objects("meshes", [&](CheckedObject& mesh, std::size_t) {
        oddities.no_primitives |= mesh.count("primitives") == 0;
        mesh.objects("primitives", [&](CheckedObject& primitive, std::size_t) {
            check_primitive(primitive, counts, has_view, oddities);
        });
        mesh.number_list("weights");
    });
    if (oddities.texcoord_gap)
        warnings.push_back("primitives have a TEXCOORD set without the one before it (not legal in glTF)");
    if (oddities.no_primitives) warnings.push_back("meshes without primitives are left out");
}

void check_nodes_and_scenes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings) {
    check_skins(root, counts);
    bool has_both = false;
    root.objects("nodes", [&](CheckedObject& node, std::size_t) {
        node.indices("children", counts.nodes);
        node.index("mesh", counts.meshes);
        node.index("camera", counts.cameras);
        node.index("skin", counts.skins);
        const bool has_matrix = !node.numbers("matrix", 16).empty();
        node.numbers("translation", 3);
        node.numbers("rotation", 4);
        node.numbers("scale", 3);
        has_both |= has_matrix && (node.has("translation") || node.has("rotation") || node.has("scale"));
        node.number_list("weights");
        node.object("extensions",
                    [&](CheckedObject& extensions) { check_node_extensions(extensions, counts); });
    });
    if (has_both)
        warnings.push_back("nodes have a matrix and translation, rotation or scale: the matrix counts");

    root.objects("scenes", [&](CheckedObject& scene, std::size_t) { scene.indices("nodes", counts.nodes); });
    root.index("scene", counts.scenes);
}

}  // namespace aoscore::gltf
