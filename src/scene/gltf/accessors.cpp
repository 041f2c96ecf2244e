#include "scene/gltf/accessors.h"

#include "core/error.h"
#include "scene/gltf/structure.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>

namespace aoscore::gltf {
namespace {

/// Bytes of the file are little endian and may be misaligned.
template <class T>
T load(const char* bytes) {
    static_assert(std::endian::native == std::endian::little, "glTF's byte order");
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

std::uint32_t load_unsigned(const char* bytes, int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return load<std::uint8_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

/// A normalised integer as the specification's "Animations" and "Accessors" chapters define it.
template <class T>
float load_integer(const char* bytes, bool normalized) {
    const auto value = static_cast<float>(load<T>(bytes));
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : value;
}

}  // namespace

void Accessor::set_layout(const Document& document, int index) {
    const tinygltf::Accessor& source = document.model->accessors.at(static_cast<std::size_t>(index));
    name_ = fmt::format("accessors[{}]", index);
    count_ = source.count;
    component_type_ = source.componentType;
    components_ = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
    normalized_ = source.normalized;
    element_bytes_ = component_bytes(component_type_) * static_cast<std::size_t>(components_);
    stride_ = element_bytes_;
}

Accessor::Accessor(const Document& document, int index, std::string_view packed, std::size_t count) {
    set_layout(document, index);
    assert(packed.size() == count * element_bytes_);
    bytes_ = packed;
    count_ = count;
}

Accessor::Accessor(Document& document, int index) {
    set_layout(document, index);
    const tinygltf::Accessor& source = document.model->accessors.at(static_cast<std::size_t>(index));
    if (source.count == 0) {
        throw file_error("is 0: there is nothing in it", fmt::format("{}: {}.count", document.where, name_),
                         "1 or more");
    }
    if (source.bufferView >= 0) {
        const std::size_t stride =
            document.model->bufferViews.at(static_cast<std::size_t>(source.bufferView)).byteStride;
        if (stride != 0) stride_ = stride;
        bytes_ = document.view_bytes(source.bufferView).substr(source.byteOffset);
    }
    if (source.sparse.isSparse) read_sparse(document, index);
}

void Accessor::read_sparse(Document& document, int index) {
    const tinygltf::Accessor& source = document.model->accessors.at(static_cast<std::size_t>(index));
    const auto& indices = source.sparse.indices;
    const std::string_view index_bytes =
        document.view_bytes(indices.bufferView).substr(static_cast<std::size_t>(indices.byteOffset));
    const std::string_view values = document.view_bytes(source.sparse.values.bufferView)
                                        .substr(static_cast<std::size_t>(source.sparse.values.byteOffset));
    const std::size_t index_size = component_bytes(indices.componentType);
    for (std::size_t i = 0; i < static_cast<std::size_t>(source.sparse.count); ++i) {
        const std::uint32_t element =
            load_unsigned(index_bytes.data() + i * index_size, indices.componentType);
        if (element >= count_) {
            throw file_error(fmt::format("replaces element {} of {}", element, count_),
                             fmt::format("{}: {}.sparse.indices", document.where, name_));
        }
        sparse_.emplace_back(element, values.data() + i * element_bytes_);
    }
    std::stable_sort(sparse_.begin(), sparse_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
}

const char* Accessor::element_at(std::size_t i) const {
    assert(i < count_);
    if (!sparse_.empty()) {
        const auto found =
            std::lower_bound(sparse_.begin(), sparse_.end(), i,
                             [](const auto& entry, std::size_t element) { return entry.first < element; });
        if (found != sparse_.end() && found->first == i) return found->second;
    }
    return bytes_.empty() ? nullptr : bytes_.data() + i * stride_;
}

float Accessor::component(const char* element, int c) const {
    const char* bytes = element + static_cast<std::size_t>(c) * component_bytes(component_type_);
    switch (component_type_) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return load_integer<std::int8_t>(bytes, normalized_);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return load_integer<std::uint8_t>(bytes, normalized_);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return load_integer<std::int16_t>(bytes, normalized_);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load_integer<std::uint16_t>(bytes, normalized_);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return load_integer<std::uint32_t>(bytes, normalized_);
        default:
            return load<float>(bytes);
    }
}

std::uint32_t Accessor::unsigned_integer(std::size_t i) const {
    const char* element = element_at(i);
    return element == nullptr ? 0 : load_unsigned(element, component_type_);
}

}  // namespace aoscore::gltf
