#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aoscore::gltf {

/// Where in a glTF file a value stands. Places are chained on the stack while the document is walked and
/// turned into a text only when something is wrong there, so that naming every value costs nothing.
class Place {
  public:
    /// The file itself.
    explicit Place(std::string_view file) : key_(file) {}
    /// A member of an object.
    Place(const Place& parent, std::string_view key) : parent_(&parent), key_(key) {}
    /// An element of an array.
    Place(const Place& parent, std::size_t index) : parent_(&parent), index_(index) {}

    /// "room.gltf: accessors[3].count".
    std::string text() const;

  private:
    const Place* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

/// A name out of a file made fit for a one-line message, see core/printable.h: at most 64 bytes of it.
std::string printable(std::string_view name);

}  // namespace aoscore::gltf
