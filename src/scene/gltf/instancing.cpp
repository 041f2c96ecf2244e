#include "scene/gltf/instancing.h"

#include "core/error.h"
#include "scene/gltf/accessors.h"
#include "scene/gltf/attribute_type.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <optional>

namespace aoscore::gltf {
namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// TRANSLATION, ROTATION and SCALE of a node's instances, each of which may be missing.
class InstanceAttributes {
  public:
    InstanceAttributes(Document& document, const tinygltf::Value& attributes, const std::string& place)
        : document_(document), place_(place) {
        translation_ = find(attributes, "TRANSLATION", {.components = {3}});
        rotation_ = find(attributes, "ROTATION", {.components = {4}, .signed_normalized = true});
        scale_ = find(attributes, "SCALE", {.components = {3}});
    }

    /// The number of instances; nothing without attributes.
    std::optional<std::size_t> count() const { return count_; }

    glm::dmat4 matrix(std::size_t i) const {
        const glm::dvec3 translation(translation_ ? translation_->vector<3>(i) : glm::vec3(0));
        const glm::dvec4 rotation(rotation_ ? rotation_->vector<4>(i) : glm::vec4(0, 0, 0, 1));
        const glm::dvec3 scale(scale_ ? scale_->vector<3>(i) : glm::vec3(1));
        const double sum = glm::dot(translation, glm::dvec3(1)) + glm::dot(scale, glm::dvec3(1)) +
                           glm::dot(rotation, glm::dvec4(1));
        if (!std::isfinite(sum)) throw file_error(fmt::format("instance {} is not finite", i), place_);
        return matrix_of_parts(translation, rotation, scale, document_);
    }

  private:
    std::optional<Accessor> find(const tinygltf::Value& attributes, const char* name,
                                 const AttributeType& type) {
        if (!attributes.Has(name)) return std::nullopt;
        std::optional<Accessor> accessor(std::in_place, document_, attributes.Get(name).GetNumberAsInt());
        const std::string place = fmt::format("{}.{}", place_, name);
        check_type(document_, *accessor, type, place);
        if (count_ && *count_ != accessor->count()) {
            throw file_error(fmt::format("{} has {} elements, another attribute {}", accessor->name(),
                                         accessor->count(), *count_),
                             place);
        }
        count_ = accessor->count();
        return accessor;
    }

    Document& document_;
    std::string place_;
    std::optional<Accessor> translation_, rotation_, scale_;
    std::optional<std::size_t> count_;
};

}  // namespace

std::vector<glm::dmat4> node_from_instances(Document& document, const tinygltf::Node& node,
                                            const std::string& place) {
    const std::vector<glm::dmat4> once = {glm::dmat4(1.0)};
    const auto found = node.extensions.find(kInstancing);
    if (found == node.extensions.end() || !found->second.Has("attributes")) return once;
    const std::string attributes_place = fmt::format("{}.extensions.{}.attributes", place, kInstancing);
    const InstanceAttributes attributes(document, found->second.Get("attributes"), attributes_place);
    if (!attributes.count()) return once;
    // Each takes a matrix here and an instance of the scene.
    document.budget.take(*attributes.count() * (sizeof(glm::dmat4) + sizeof(Instance)), attributes_place);
    std::vector<glm::dmat4> matrices;
    matrices.reserve(*attributes.count());
    for (std::size_t i = 0; i < *attributes.count(); ++i) matrices.push_back(attributes.matrix(i));
    return matrices;
}

}  // namespace aoscore::gltf
