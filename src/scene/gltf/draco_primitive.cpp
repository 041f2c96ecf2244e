#include "scene/gltf/draco_primitive.h"

#include "core/error.h"
#include "scene/gltf/document.h"
#include "scene/gltf/draco_header.h"
#include "scene/gltf/structure.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <tiny_gltf.h>

namespace aoscore::gltf {
namespace {

/// The bytes of the decoder's tables, faces, points and values together, for each face.
constexpr std::size_t kBytesPerFace = 128;

std::unique_ptr<draco::Mesh> decode(std::string_view stream) {
    draco::DecoderBuffer buffer;
    buffer.Init(stream.data(), stream.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    return decoded.ok() ? std::move(decoded).value() : nullptr;
}

/// Whether every point has a value of the attribute.
bool is_complete(const draco::PointAttribute& attribute, std::size_t points) {
    if (!attribute.is_mapping_identity() && attribute.indices_map_size() < points) return false;
    for (std::uint32_t i = 0; i < points; ++i) {
        if (attribute.mapped_index(draco::PointIndex(i)).value() >= attribute.size()) return false;
    }
    return true;
}

template <class T>
bool pack(const draco::PointAttribute& attribute, std::size_t points, std::size_t components,
          std::string& bytes) {
    const std::size_t stride = components * sizeof(T);
    bytes.resize(points * stride);
    T element[4];
    for (std::uint32_t i = 0; i < points; ++i) {
        const auto value = attribute.mapped_index(draco::PointIndex(i));
        if (!attribute.ConvertValue<T>(value, static_cast<std::int8_t>(components), element)) return false;
        std::memcpy(&bytes[i * stride], element, stride);
    }
    return true;
}

bool pack_as(int component_type, const draco::PointAttribute& attribute, std::size_t points,
             std::size_t components, std::string& bytes) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return pack<std::int8_t>(attribute, points, components, bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return pack<std::uint8_t>(attribute, points, components, bytes);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return pack<std::int16_t>(attribute, points, components, bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return pack<std::uint16_t>(attribute, points, components, bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return pack<std::uint32_t>(attribute, points, components, bytes);
        default:
            return pack<float>(attribute, points, components, bytes);
    }
}

}  // namespace

DracoPrimitive::DracoPrimitive(Document& document, std::string_view stream, const std::string& where)
    : where_(where) {
    document.budget.take(stated_draco_faces(stream, where) * kBytesPerFace, where);
    try {
        mesh_ = decode(stream);
    } catch (const std::exception&) {
        mesh_ = nullptr;  // out of memory: the stream states more than it holds
    }
    if (!mesh_) throw file_error("is a broken Draco stream", where);
}

DracoPrimitive::~DracoPrimitive() = default;

std::size_t DracoPrimitive::vertices() const {
    return mesh_->num_points();
}

std::vector<std::uint32_t> DracoPrimitive::corners() const {
    std::vector<std::uint32_t> corners;
    corners.reserve(std::size_t{3} * mesh_->num_faces());
    for (std::uint32_t i = 0; i < mesh_->num_faces(); ++i) {
        for (const draco::PointIndex& point : mesh_->face(draco::FaceIndex(i)))
            corners.push_back(point.value());
    }
    return corners;
}

std::string DracoPrimitive::packed(Document& document, int id, int accessor) const {
    const draco::PointAttribute* attribute = mesh_->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    if (attribute == nullptr) throw file_error(fmt::format("has no attribute of id {}", id), where_);
    const tinygltf::Accessor& layout = document.model->accessors.at(static_cast<std::size_t>(accessor));
    const auto components =
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(layout.type)));
    document.budget.take(vertices() * components * component_bytes(layout.componentType), where_);
    std::string bytes;
    if (components > 4 || !is_complete(*attribute, vertices()) ||
        !pack_as(layout.componentType, *attribute, vertices(), components, bytes)) {
        throw file_error(fmt::format("its attribute of id {} does not fit accessors[{}]", id, accessor),
                         where_);
    }
    return bytes;
}

}  // namespace aoscore::gltf
