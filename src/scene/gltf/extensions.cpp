#include "scene/gltf/extensions.h"

#include "scene/gltf/place.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace aoscore::gltf {
namespace {

using nlohmann::json;
using enum Extension::Effect;

const Extension* find(std::string_view name) {
    const auto found = std::find_if(extensions().begin(), extensions().end(),
                                    [&](const Extension& extension) { return extension.name == name; });
    return found == extensions().end() ? nullptr : &*found;
}

void collect(const json& value, std::set<std::string>& names) {
    if (value.is_array()) {
        for (const json& element : value) collect(element, names);
    }
    if (!value.is_object()) return;
    for (const auto& [key, member] : value.items()) {
        if (key == "extras") continue;  // belongs to the application
        if (key == "extensions" && member.is_object()) {
            for (const auto& [name, unused] : member.items()) names.insert(name);
        }
        collect(member, names);
    }
}

}  // namespace

const std::vector<Extension>& extensions() {
    static const std::vector<Extension> table = {
        {"EXT_mesh_gpu_instancing", read},
        {"EXT_meshopt_compression", read},
        {"EXT_texture_webp", read},
        {"KHR_draco_mesh_compression", read},
        {"KHR_materials_pbrSpecularGlossiness", read},
        {"KHR_materials_variants", read},
        {"KHR_mesh_quantization", read},
        {"KHR_meshopt_compression", read},
        {"KHR_node_visibility", read},
        {"KHR_texture_transform", read},
        // These images cannot be decoded; the warning comes where a cut-out or an albedo asks for one.
        {"EXT_texture_astc", read},
        {"EXT_texture_avif", read},
        {"KHR_texture_basisu", read},
        {"MSFT_texture_dds", read},

        {"ADOBE_materials_clearcoat_specular", none},
        {"ADOBE_materials_clearcoat_tint", none},
        {"ADOBE_materials_thin_transparency", none},
        {"AGI_stk_metadata", none},
        {"CESIUM_primitive_outline", none},
        {"CESIUM_RTC", none},  // moves the scene as a whole
        {"EXT_feature_metadata", none},
        {"EXT_instance_features", none},
        {"EXT_lights_ies", none},
        {"EXT_lights_image_based", none},
        {"EXT_mesh_features", none},
        {"EXT_mesh_manifold", none},
        {"EXT_mesh_primitive_edge_visibility", none},
        {"EXT_structural_metadata", none},
        {"FB_geometry_metadata", none},
        {"FB_ngon_encoding", none},  // which triangles make up a polygon
        {"GODOT_single_root", none},
        {"GRIFFEL_bim_data", none},
        {"KHR_animation_pointer", none},  // nothing moves at rest
        {"KHR_audio_emitter", none},
        {"KHR_audio_graph", none},
        {"KHR_implicit_shapes", none},  // shapes for physics, not drawn
        {"KHR_lights_punctual", none},
        {"KHR_materials_anisotropy", none},
        {"KHR_materials_clearcoat", none},
        {"KHR_materials_diffuse_transmission", none},
        {"KHR_materials_dispersion", none},
        {"KHR_materials_emissive_strength", none},
        {"KHR_materials_ior", none},
        {"KHR_materials_iridescence", none},
        {"KHR_materials_sheen", none},
        {"KHR_materials_specular", none},
        {"KHR_materials_transmission", none},  // glass is a surface
        {"KHR_materials_unlit", none},
        {"KHR_materials_volume", none},
        {"KHR_materials_volume_scatter", none},
        {"KHR_node_hoverability", none},
        {"KHR_node_selectability", none},
        {"KHR_physics_rigid_bodies", none},
        {"KHR_xmp", none},
        {"KHR_xmp_json_ld", none},
        {"MPEG_animation_timing", none},
        {"MPEG_audio_spatial", none},
        {"MPEG_media", none},
        {"MPEG_viewport_recommended", none},
        {"MSFT_audio_emitter", none},
        {"MSFT_lod", none},  // the node itself is the finest level
        {"MSFT_packing_normalRoughnessMetallic", none},
        {"MSFT_packing_occlusionRoughnessMetallic", none},
        {"OMI_physics_body", none},
        {"OMI_physics_shape", none},
        {"VRMC_materials_hdr_emissiveMultiplier", none},
        {"VRMC_materials_mtoon", none},  // outlines are no surfaces
        {"VRMC_node_constraint", none},
        {"VRMC_springBone", none},
        {"VRMC_vrm", none},

        {"AGI_articulations", surfaces,
         "articulated nodes stand as in the file, not at their initial values"},
        {"EXT_mesh_primitive_restart", surfaces, "strips and fans do not begin again within a primitive"},
        {"EXT_primitive_voxels", surfaces, "voxels are not drawn"},
        {"KHR_gaussian_splatting", surfaces, "splats are not drawn: they have no surface"},
        {"KHR_interactivity", surfaces, "what its graph moves or hides at the start stands as in the file"},
        {"KHR_techniques_webgl", surfaces, "what its shaders displace or cut away stands as the file's mesh"},
        {"KHR_texture_procedurals", surfaces, "what a procedural texture cuts away is solid"},
        {"MPEG_accessor_timed", surfaces, "meshes that change over time stand as the file holds them"},
        {"MPEG_buffer_circular", surfaces, "meshes that change over time stand as the file holds them"},
        {"MPEG_mesh_linking", surfaces, "linked meshes are not fitted to each other"},
        {"MPEG_scene_dynamic", surfaces, "the scene is drawn as the file holds it, without its updates"},
        {"MPEG_texture_video", surfaces, "what a video cuts away is solid"},
        {"NV_materials_mdl", surfaces, "what its materials displace or cut away stands as the file's mesh"},
        {"VRM", surfaces, "what only its own materials cut away is solid"},
    };
    return table;
}

std::set<std::string> extensions_carried(const json& root) {
    std::set<std::string> names;
    collect(root, names);
    return names;
}

std::string loss_without(const std::string& name) {
    const Extension* extension = find(name);
    if (extension == nullptr)
        return printable(name) + " is unknown here: surfaces that it may add, move, hide or cut are not";
    if (extension->effect != surfaces) return {};
    return name + " is not read: " + std::string(extension->loss);
}

bool is_honoured(std::string_view name) {
    const Extension* extension = find(name);
    return extension != nullptr && extension->effect != surfaces;
}

}  // namespace aoscore::gltf
