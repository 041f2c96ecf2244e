#include "scene/gltf/pose.h"

#include "core/error.h"
#include "scene/gltf/accessors.h"
#include "scene/gltf/attribute_type.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <utility>

namespace aoscore::gltf {
namespace {

bool is_skinned(const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), [](const auto& primitive) {
        return primitive.attributes.contains("JOINTS_0") && primitive.attributes.contains("WEIGHTS_0");
    });
}

std::size_t target_count(const tinygltf::Mesh& mesh) {
    std::size_t count = 0;
    for (const auto& primitive : mesh.primitives) count = std::max(count, primitive.targets.size());
    return count;
}

glm::dmat4 matrix_at(const Accessor& accessor, std::size_t i) {
    const auto values = accessor.elements<16>(i);
    glm::dmat4 matrix(1.0);
    for (std::size_t k = 0; k < values.size(); ++k)
        matrix[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = static_cast<double>(values[k]);
    return matrix;
}

}  // namespace

Pose pose_of(Document& document, const tinygltf::Node& node) {
    const tinygltf::Mesh& mesh = document.model->meshes.at(static_cast<std::size_t>(node.mesh));
    Pose pose;
    pose.weights = node.weights.empty() ? mesh.weights : node.weights;
    const std::size_t targets = target_count(mesh);
    if (!pose.weights.empty() && pose.weights.size() != targets) {
        document.warn(fmt::format("meshes[{}] has {} morph targets and {} weights: missing weights are 0",
                                  node.mesh, targets, pose.weights.size()));
        pose.weights.resize(targets);
    }
    if (std::all_of(pose.weights.begin(), pose.weights.end(), [](double w) { return w == 0; }))
        pose.weights.clear();
    if (node.skin < 0) return pose;
    if (is_skinned(mesh)) {
        pose.skin = node.skin;
    } else {
        document.warn("nodes have a skin and a mesh without joints: placed by themselves");
    }
    return pose;
}

Skins::Skins(Document& document, const std::vector<PlacedNode>& nodes) : document_(document) {
    if (document.skins.empty()) return;
    for (const PlacedNode& placed : nodes) {
        world_from_node_.emplace(placed.node, placed.world_from_node);
        if (placed.is_dynamic) dynamic_nodes_.insert(placed.node);
    }
}

bool Skins::is_dynamic(int skin) const {
    return std::ranges::any_of(document_.skins[static_cast<std::size_t>(skin)].joints,
                               [&](int joint) { return dynamic_nodes_.contains(joint); });
}

const JointMatrices& Skins::joints(int skin) {
    const auto [entry, is_new] = read_.try_emplace(skin);
    if (is_new) entry->second = read(skin);
    return entry->second;
}

JointMatrices Skins::read(int skin) {
    const SkinSource& source = document_.skins.at(static_cast<std::size_t>(skin));
    const std::string place = fmt::format("{}: skins[{}]", document_.where, skin);
    std::optional<Accessor> inverse_binds;
    if (source.inverse_bind_matrices >= 0) {
        inverse_binds.emplace(document_, source.inverse_bind_matrices);
        check_type(document_, *inverse_binds, {.components = {16}}, place + ".inverseBindMatrices");
        if (inverse_binds->count() < source.joints.size()) {
            throw file_error(fmt::format("{} has {} matrices for {} joints", inverse_binds->name(),
                                         inverse_binds->count(), source.joints.size()),
                             place + ".inverseBindMatrices");
        }
    }
    JointMatrices result;
    for (std::size_t i = 0; i < source.joints.size(); ++i) {
        const glm::dmat4& world = world_from_joint(source.joints[i]);
        if (i == 0) result.anchor = glm::dvec3(world[3]);
        const glm::dmat4 joint_from_mesh = inverse_binds ? matrix_at(*inverse_binds, i) : glm::dmat4(1.0);
        result.anchored_from_mesh.push_back(glm::translate(glm::dmat4(1.0), -result.anchor) * world *
                                            joint_from_mesh);
    }
    return result;
}

const glm::dmat4& Skins::world_from_joint(int node) {
    const auto found = world_from_node_.find(node);
    if (found != world_from_node_.end()) return found->second;
    document_.warn("joints of skins are outside of the scene (not legal in glTF): placed by their parents");
    return world_from_node_.emplace(node, world_from_detached(document_, node)).first->second;
}

}  // namespace aoscore::gltf
