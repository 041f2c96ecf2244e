#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace aoscore::gltf {

/// The way from a mesh's texture coordinates to those of a material's base colour.
struct TexcoordSource {
    bool wanted = false;               ///< false: no texture is sampled, meshes need no texture coordinates
    std::string attribute;             ///< "TEXCOORD_0"
    glm::dmat3 uv_from_texcoord{1.0};  ///< KHR_texture_transform; applied to (u, v, 1)
};

/// A document's materials and the textures they need.
struct MaterialTable {
    std::vector<Material> materials;        ///< the document's, then the default material
    std::vector<TexcoordSource> texcoords;  ///< texture coordinates of each material
    std::vector<Texture> textures;

    /// The index in the table of a primitive's `material` (-1: none).
    int index_of(int material) const {
        return material < 0 ? static_cast<int>(materials.size()) - 1 : material;
    }
};

/// Reads factors and cut-outs, and decodes the base-colour textures of cut-outs (of all materials with
/// `albedo`). make_uncut_solid() decides about the alphas of vertices. An image that is missing or broken is
/// a warning, and its cut-out becomes solid; open_document() has refused images outside of the folder.
MaterialTable read_materials(Document& document, bool albedo);

}  // namespace aoscore::gltf
