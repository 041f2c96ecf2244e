#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace aoscore::importer {

/// One corner of a polygon, in the file's coordinates.
struct Corner {
    glm::dvec3 position{0};
    glm::vec3 normal{0};
    glm::vec2 texcoord{0};
};

/// Gathers polygons of one material to a mesh: corners that are the same to the last bit become one vertex.
class SurfaceBuilder {
  public:
    struct Attributes {
        int material = 0;
        bool normals = false;
        bool texcoords = false;
        auto operator<=>(const Attributes&) const = default;
    };
    explicit SurfaceBuilder(const Attributes& attributes) : attributes_(attributes) {}

    /// Splits the polygon, the `face`-th of its file, into triangles. Throws file_error for a position that
    /// is no number, or that float32 cannot hold.
    void add(std::span<const Corner> polygon, std::size_t face);

    std::size_t triangle_count() const { return triangles_.size(); }
    bool empty() const { return triangles_.empty(); }

    struct Built {
        Mesh mesh;
        /// The origin of the mesh's positions: zero, but where the mesh lies so far off for its size that
        /// float32 would lose its details.
        glm::dvec3 centre{0};
    };
    /// Returns the mesh of all that was added, and empties the builder.
    Built take();

  private:
    std::uint32_t vertex_of(const Corner& corner);
    void grow_table();

    Attributes attributes_;
    std::vector<Corner> vertices_;
    std::vector<glm::uvec3> triangles_;
    std::vector<std::uint32_t> table_;  // open addressing: index + 1, or 0; its length is a power of two
    std::vector<glm::dvec3> corner_positions_;
};

}  // namespace aoscore::importer
