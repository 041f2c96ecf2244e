#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/pose.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aoscore::gltf {

class VertexReader;

/// One primitive decoded. Its positions are relative to `centre`, which is zero unless the mesh lies so far
/// from its own zero that float32 transforms would lose details its coordinates still have, or is skinned.
struct DecodedMesh {
    Mesh mesh;
    glm::dvec3 centre{0};
};

/// Decodes the primitives of meshes as they are asked for.
class MeshReader {
  public:
    MeshReader(Document& document, const MaterialTable& materials, Skins& skins)
        : document_(document), materials_(materials), skins_(skins) {}

    /// All primitives of a mesh that have triangles: morphed and skinned as the pose says (a skinned mesh is
    /// in the world's coordinates), strips and fans taken apart, only the vertices that are used, triangles
    /// without area left out and counted. Throws file_error for indices out of range, positions that are not
    /// finite, and attributes of types that glTF does not allow.
    std::vector<DecodedMesh> read(int mesh, const Pose& pose);

    /// How many triangles without area were left out so far.
    std::size_t degenerate_triangles() const { return degenerate_triangles_; }

  private:
    std::optional<DecodedMesh> read_primitive(int mesh, std::size_t primitive, const Pose& pose);
    /// Fills the mesh with the vertices that the corners use, and its triangles with their new indices.
    void compact(Mesh& mesh, VertexReader& vertices);

    Document& document_;
    const MaterialTable& materials_;
    Skins& skins_;
    std::size_t degenerate_triangles_ = 0;
    std::vector<std::uint32_t> new_index_;  // of each old vertex while a primitive is read; kUnused else
};

}  // namespace aoscore::gltf
