#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace aoscore::gltf {

/// How the texture coordinates of a material's base colour are made from a mesh's.
struct TexcoordSource {
    bool wanted = false;               ///< false: no texture is sampled, meshes need no texture coordinates
    std::string attribute;             ///< "TEXCOORD_0"
    glm::dmat3 uv_from_texcoord{1.0};  ///< KHR_texture_transform; applied to (u, v, 1)
};

/// A document's materials and the textures they need.
struct MaterialTable {
    std::vector<Material> materials;        ///< the document's, then the default material
    std::vector<TexcoordSource> texcoords;  ///< one a material
    std::vector<Texture> textures;

    /// Where `material` of a primitive (-1: none) is in the table.
    int index_of(int material) const {
        return material < 0 ? static_cast<int>(materials.size()) - 1 : material;
    }
};

/// Reads factors and cut-outs, and decodes the base-colour textures of cut-outs (of all materials with
/// `albedo`). What the vertices' alpha may cut is left to make_uncut_solid(). An image that is missing or
/// broken is a warning, and its cut-out becomes solid; an image whose URI leaves the folder was an error
/// before.
MaterialTable read_materials(Document& document, bool albedo);

}  // namespace aoscore::gltf
