#include "scene/gltf/vertex_reader.h"

#include "core/error.h"
#include "scene/cofactors.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore::gltf {
namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

VertexReader::VertexReader(Document& document, const tinygltf::Primitive& primitive, PrimitiveData& data,
                           const TexcoordSource& texcoords, bool with_alpha,
                           const std::vector<double>& weights, const JointMatrices* joints)
    : document_(document),
      primitive_(primitive),
      data_(data),
      texcoord_source_(texcoords),
      weights_(weights) {
    positions_ = find("POSITION", {.components = {3}, .quantized = true});
    if (!positions_) {
        document_.warn("primitives without POSITION are left out");
        return;
    }
    const auto& source =
        document_.model->accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    if (source.minValues.empty() || source.maxValues.empty())
        document_.warn("POSITION accessors lack min and max (not legal in glTF): taken from the data");
    normals_ = find("NORMAL", {.components = {3}, .quantized = true});
    if (texcoord_source_.wanted) find_texcoords();
    if (with_alpha) find_alphas();
    if (joints != nullptr) skin_.emplace(document, data, *joints, count());
}

std::optional<MorphedAttribute> VertexReader::find(const std::string& name, const AttributeType& type) {
    const std::optional<Accessor> base = data_.attribute(name, type);
    if (!base) return std::nullopt;
    if (positions_ && base->count() != count()) {
        throw file_error(
            fmt::format("{} has {} elements, POSITION has {}", base->name(), base->count(), count()),
            data_.place() + ".attributes");
    }
    return MorphedAttribute(document_, primitive_, name, *base, weights_, data_.place());
}

void VertexReader::find_texcoords() {
    const std::string& name = texcoord_source_.attribute;
    texcoords_ = find(name, {.components = {2}, .unsigned_integers = true, .quantized = true});
    if (!texcoords_)
        document_.warn(fmt::format("primitives lack {}, which their material samples: taken as 0, 0", name));
}

void VertexReader::find_alphas() {
    const auto found = primitive_.attributes.find("COLOR_0");
    if (found == primitive_.attributes.end()) return;
    constexpr int kRgba = 4;
    const auto& source = document_.model->accessors[static_cast<std::size_t>(found->second)];
    // RGB alone has an alpha of 1.
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type)) != kRgba) return;
    colours_ = find("COLOR_0", {.components = {kRgba}, .unsigned_integers = true});
}

void VertexReader::append(Mesh& mesh, std::uint32_t i) const {
    glm::vec3 position = positions_->vector<3>(i);
    glm::vec3 normal = normals_ ? normals_->vector<3>(i) : glm::vec3(0);
    if (skin_) {
        const glm::dmat4 matrix = skin_->matrix(i);
        position = glm::vec3(matrix * glm::dvec4(position, 1));
        normal = glm::vec3(cofactors(glm::dmat3(matrix)) * glm::dvec3(normal));
    }
    if (!is_finite(position)) {
        throw file_error(
            fmt::format("position {} is not finite", i),
            fmt::format("{}: accessors[{}]", document_.where, primitive_.attributes.at("POSITION")));
    }
    mesh.positions.push_back(position);
    if (normals_) mesh.normals.push_back(normal);
    if (texcoord_source_.wanted) {
        const glm::dvec3 uv1(texcoords_ ? texcoords_->vector<2>(i) : glm::vec2(0), 1.0);
        mesh.texcoords.emplace_back(texcoord_source_.uv_from_texcoord * uv1);
    }
    if (colours_) {
        const float alpha = colours_->vector<4>(i).a;
        if (!std::isfinite(alpha)) document_.warn("COLOR_0 holds an alpha that is not finite: taken as 1");
        mesh.alphas.push_back(std::isfinite(alpha) ? std::clamp(alpha, 0.0f, 1.0f) : 1.0f);
    }
}

}  // namespace aoscore::gltf
