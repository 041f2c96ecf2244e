#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aoscore::gltf {

/// The place of a value in a glTF file. Places are chained on the stack while the document is walked, and
/// become a text only for an error, so that naming every value costs nothing.
class Place {
  public:
    /// The place of the whole file.
    explicit Place(std::string_view file) : key_(file) {}
    /// The place of an object's member.
    Place(const Place& parent, std::string_view key) : parent_(&parent), key_(key) {}
    /// The place of an array's element.
    Place(const Place& parent, std::size_t index) : parent_(&parent), index_(index) {}

    /// Such as "room.gltf: accessors[3].count".
    std::string text() const;

  private:
    const Place* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

/// Makes at most 64 bytes of a name from a file fit for a one-line message (see core/printable.h).
std::string printable(std::string_view name);

}  // namespace aoscore::gltf
