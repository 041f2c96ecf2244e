#include "scene/gltf/primitive_data.h"

#include "core/error.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace aoscore::gltf {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
/// The bytes of a corner's index, and of its share of a triangle and its vertices.
constexpr std::size_t kBytesPerCorner = 4 + 12;

}  // namespace

PrimitiveData::PrimitiveData(Document& document, const tinygltf::Primitive& primitive, std::string place)
    : document_(document), primitive_(primitive), place_(std::move(place)) {
    const auto found = primitive.extensions.find(kDraco);
    if (found == primitive.extensions.end()) return;
    const int view = found->second.Get("bufferView").GetNumberAsInt();
    draco_ = std::make_unique<DracoPrimitive>(document, document.view_bytes(view),
                                              fmt::format("{}.extensions.{}", place_, kDraco));
}

int PrimitiveData::draco_id(const std::string& name) const {
    if (!draco_) return -1;
    const tinygltf::Value ids = primitive_.extensions.at(kDraco).Get("attributes");
    return ids.Has(name) ? ids.Get(name).GetNumberAsInt() : -1;
}

std::optional<Accessor> PrimitiveData::attribute(const std::string& name, const AttributeType& type) {
    const auto found = primitive_.attributes.find(name);
    if (found == primitive_.attributes.end()) return std::nullopt;
    std::optional<Accessor> accessor;
    if (const int id = draco_id(name); id >= 0) {
        packed_.push_back(draco_->packed(document_, id, found->second));
        accessor.emplace(document_, found->second, packed_.back(), draco_->vertices());
        if (document_.model->accessors[static_cast<std::size_t>(found->second)].count != accessor->count())
            document_.warn(
                "accessors state another count than their Draco stream holds: the stream's is taken");
    } else {
        accessor.emplace(document_, found->second);
    }
    check_type(document_, *accessor, type, place_ + ".attributes." + name);
    return accessor;
}

int PrimitiveData::mode() const {
    // Draco's faces are single triangles, whatever the primitive says.
    return draco_ || primitive_.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive_.mode;
}

std::vector<std::uint32_t> PrimitiveData::corners(std::size_t vertices) {
    std::vector<std::uint32_t> corners = draco_ ? draco_->corners() : accessor_corners(vertices);
    const auto beyond = std::find_if(corners.begin(), corners.end(), [&](auto c) { return c >= vertices; });
    if (beyond != corners.end()) {
        throw file_error(
            fmt::format("index {} is vertex {} of {}", beyond - corners.begin(), *beyond, vertices),
            primitive_.indices < 0 ? place_
                                   : fmt::format("{}: accessors[{}]", document_.where, primitive_.indices));
    }
    return corners;
}

std::vector<std::uint32_t> PrimitiveData::accessor_corners(std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    if (primitive_.indices < 0) {
        document_.budget.take(vertices * kBytesPerCorner, place_);
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0u);
        return corners;
    }
    const Accessor indices(document_, primitive_.indices);
    const int type = indices.component_type();
    if (indices.components() != 1 ||
        (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
         type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        throw file_error(indices.name() + " has a type that it may not have", place_ + ".indices",
                         "unsigned integer scalars");
    }
    document_.budget.take(indices.count() * kBytesPerCorner, place_);
    corners.resize(indices.count());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = indices.unsigned_integer(i);
    return corners;
}

}  // namespace aoscore::gltf
