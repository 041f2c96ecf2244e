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

/// A decoded primitive. Its positions are relative to `centre`, which is zero unless the mesh is skinned, or
/// lies so far from its own origin that float32 transforms would lose details.
struct DecodedMesh {
    Mesh mesh;
    glm::dvec3 centre{0};
};

/// Decodes the primitives of meshes as they are asked for.
class MeshReader {
  public:
    MeshReader(Document& document, const MaterialTable& materials, Skins& skins)
        : document_(document), materials_(materials), skins_(skins) {}

    /// Decodes all primitives of a mesh that have triangles. They are morphed and skinned as the pose says (a
    /// skinned mesh is in world coordinates), strips and fans become triangles, only vertices in use are
    /// kept, and triangles without area are left out and counted. Throws file_error for indices out of range,
    /// positions that are not finite, and attributes of types that glTF does not allow.
    std::vector<DecodedMesh> read(int mesh, const Pose& pose);

    /// The number of triangles without area that were left out so far.
    std::size_t degenerate_triangles() const { return degenerate_triangles_; }

  private:
    std::optional<DecodedMesh> read_primitive(int mesh, std::size_t primitive, const Pose& pose);
    /// Fills the mesh with the vertices that the corners use, and its triangles with their new indices.
    void compact(Mesh& mesh, VertexReader& vertices);

    Document& document_;
    const MaterialTable& materials_;
    Skins& skins_;
    std::size_t degenerate_triangles_ = 0;
    std::vector<std::uint32_t> new_index_;  // of each vertex read; kUnused where no triangle uses it
};

}  // namespace aoscore::gltf
