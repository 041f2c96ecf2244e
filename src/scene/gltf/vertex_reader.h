#pragma once

#include "scene/gltf/materials.h"
#include "scene/gltf/morphed_attribute.h"
#include "scene/gltf/pose.h"
#include "scene/gltf/primitive_data.h"
#include "scene/gltf/skinned_vertices.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace tinygltf {
struct Primitive;
}

namespace aoscore::gltf {

/// The vertices of a primitive in its pose, with the attributes that its material needs.
class VertexReader {
  public:
    /// Throws file_error for attributes that are not of one count or of a type that glTF does not allow.
    VertexReader(Document& document, const tinygltf::Primitive& primitive, PrimitiveData& data,
                 const TexcoordSource& texcoords, bool with_alpha, const std::vector<double>& weights,
                 const JointMatrices* joints);

    /// False for a primitive without POSITION.
    bool has_positions() const { return positions_.has_value(); }
    std::size_t count() const { return positions_->count(); }
    /// Appends vertex `i`. Throws file_error for a position that is not finite.
    void append(Mesh& mesh, std::uint32_t i) const;

  private:
    std::optional<MorphedAttribute> find(const std::string& name, const AttributeType& type);
    void find_texcoords();
    void find_alphas();

    Document& document_;
    const tinygltf::Primitive& primitive_;
    PrimitiveData& data_;
    const TexcoordSource& texcoord_source_;
    const std::vector<double>& weights_;
    std::optional<MorphedAttribute> positions_, normals_, texcoords_, colours_;
    std::optional<SkinnedVertices> skin_;
};

}  // namespace aoscore::gltf
