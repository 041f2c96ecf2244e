#pragma once

#include "scene/gltf/attribute_type.h"
#include "scene/gltf/document.h"
#include "scene/gltf/draco_primitive.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tinygltf {
struct Primitive;
}

namespace aoscore::gltf {

/// The source of a primitive's triangles and attributes: accessors, or a decoded Draco stream.
class PrimitiveData {
  public:
    /// Decodes the primitive's Draco stream, where it has one. All arguments must outlive this object.
    PrimitiveData(Document& document, const tinygltf::Primitive& primitive, std::string place);

    /// Such as "room.gltf: meshes[0].primitives[2]".
    const std::string& place() const { return place_; }
    /// The attribute, checked to be of that type; nothing when the primitive has none.
    std::optional<Accessor> attribute(const std::string& name, const AttributeType& type);
    /// The vertex of each corner, in the order of the primitive's topology, all less than `vertices`.
    std::vector<std::uint32_t> corners(std::size_t vertices);
    /// glTF's mode of the corners that corners() returns: 4 to 6.
    int mode() const;

  private:
    std::vector<std::uint32_t> accessor_corners(std::size_t vertices);
    int draco_id(const std::string& name) const;

    Document& document_;
    const tinygltf::Primitive& primitive_;
    std::string place_;
    std::unique_ptr<DracoPrimitive> draco_;
    std::deque<std::string> packed_;  // attributes that Draco decoded
};

}  // namespace aoscore::gltf
