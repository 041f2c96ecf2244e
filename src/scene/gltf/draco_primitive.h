#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace draco {
class Mesh;
}

namespace aoscore::gltf {

struct Document;

/// The triangles and attributes of a primitive that KHR_draco_mesh_compression holds in one stream (Khronos
/// Group; decoded by Google's Draco library).
class DracoPrimitive {
  public:
    /// Throws file_error at `where` for a broken stream, for one without triangles, and for one that states
    /// more than it can hold.
    DracoPrimitive(Document& document, std::string_view stream, const std::string& where);
    ~DracoPrimitive();

    std::size_t vertices() const;
    /// The vertices of all triangles, three each.
    std::vector<std::uint32_t> corners() const;
    /// The attribute of this id, converted to the components of accessor `accessor`, tightly packed.
    std::string packed(Document& document, int id, int accessor) const;

  private:
    std::string where_;
    std::unique_ptr<draco::Mesh> mesh_;
};

}  // namespace aoscore::gltf
