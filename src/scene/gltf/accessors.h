#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore::gltf {

/// Random access to the elements of an accessor, whatever its component type, stride, normalisation or sparse
/// replacements. The document must outlive it; its extents were checked when it was opened.
class Accessor {
  public:
    Accessor(Document& document, int index);
    /// The accessor's layout over `count` elements of other data, tightly packed, which must outlive it.
    Accessor(const Document& document, int index, std::string_view packed, std::size_t count);

    std::size_t count() const { return count_; }
    int component_type() const { return component_type_; }
    int components() const { return components_; }
    bool normalized() const { return normalized_; }
    /// "accessors[3]", for messages.
    const std::string& name() const { return name_; }

    /// Element `i` as floats: integers are scaled to [0,1] or [-1,1] when the accessor is normalised. `N`
    /// must not exceed components().
    template <int N>
    glm::vec<N, float> vector(std::size_t i) const {
        const char* element = element_at(i);
        glm::vec<N, float> value(0.0f);
        if (element == nullptr) return value;
        for (int c = 0; c < N; ++c) value[c] = component(element, c);
        return value;
    }
    /// All components of element `i`, converted likewise; `N` must be components().
    template <std::size_t N>
    std::array<float, N> elements(std::size_t i) const {
        std::array<float, N> values{};
        const char* element = element_at(i);
        for (std::size_t c = 0; element != nullptr && c < N; ++c)
            values[c] = component(element, static_cast<int>(c));
        return values;
    }
    /// Element `i` of an accessor of unsigned integers.
    std::uint32_t unsigned_integer(std::size_t i) const;

  private:
    void set_layout(const Document& document, int index);
    void read_sparse(Document& document, int index);
    /// Null where there is no data: such elements are zero.
    const char* element_at(std::size_t i) const;
    float component(const char* element, int c) const;

    std::string name_;
    std::size_t count_ = 0;
    int component_type_ = 0;
    int components_ = 0;
    bool normalized_ = false;
    std::string_view bytes_;
    std::size_t stride_ = 0;
    std::size_t element_bytes_ = 0;
    std::vector<std::pair<std::uint32_t, const char*>> sparse_;  // replaced elements, sorted by index
};

}  // namespace aoscore::gltf
