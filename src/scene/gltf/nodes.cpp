#include "scene/gltf/nodes.h"

#include "core/error.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace aoscore::gltf {
namespace {

bool is_finite(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(m[column][row])) return false;
        }
    }
    return true;
}

bool has_shear(const glm::dmat4& m) {
    constexpr double kTolerance = 1e-4;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const auto skewed = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::abs(glm::dot(a, b)) > kTolerance * glm::length(a) * glm::length(b);
    };
    return skewed(x, y) || skewed(y, z) || skewed(z, x);
}

glm::dmat4 matrix_of(const tinygltf::Node& node, const std::string& place, Document& document) {
    constexpr double kRounding = 1e-6;
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    const glm::dvec4 off = glm::transpose(matrix)[3] - glm::dvec4(0, 0, 0, 1);
    if (!(glm::length(off) <= kRounding))
        throw file_error("is not affine: its last row is not 0 0 0 1", place + ".matrix");
    for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1 : 0;
    if (has_shear(matrix)) document.warn("node matrices with shear (not legal in glTF) are used as they are");
    return matrix;
}

glm::dmat4 parent_from_node(const tinygltf::Node& node, const std::string& place, Document& document) {
    if (!node.matrix.empty()) return matrix_of(node, place, document);
    const auto part = [](const std::vector<double>& values, double otherwise) {
        return values.empty() ? glm::dvec3(otherwise) : glm::dvec3(values[0], values[1], values[2]);
    };
    const glm::dvec4 rotation = node.rotation.empty() ? glm::dvec4(0, 0, 0, 1)
                                                      : glm::dvec4(node.rotation[0], node.rotation[1],
                                                                   node.rotation[2], node.rotation[3]);
    return matrix_of_parts(part(node.translation, 0), rotation, part(node.scale, 1), document);
}

bool is_visible(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_node_visibility");
    return found == node.extensions.end() || !found->second.Has("visible") ||
           found->second.Get("visible").Get<bool>();
}

/// What "extras" of a node say of its movement: true, false, or the 1 or 0 that Blender writes for them.
std::optional<bool> said_to_move(Document& document, int index) {
    const tinygltf::Value& extras = document.model->nodes[static_cast<std::size_t>(index)].extras;
    if (!extras.Has("dynamic")) return std::nullopt;
    const tinygltf::Value& said = extras.Get("dynamic");
    if (said.IsBool()) return said.Get<bool>();
    const double number = said.IsNumber() ? said.GetNumberAsDouble() : -1;
    if (number == 0 || number == 1) return number == 1;
    document.warn(fmt::format(R"(nodes[{}].extras.dynamic is neither true nor false, and not used)", index));
    return std::nullopt;
}

bool is_dynamic(Document& document, int index, bool parent_is_dynamic) {
    return said_to_move(document, index)
        .value_or(parent_is_dynamic || document.animated_nodes.contains(index));
}

std::vector<int> root_nodes(Document& document) {
    const tinygltf::Model& model = *document.model;
    if (model.nodes.empty()) throw file_error("has no nodes: the scene is empty", document.where);
    if (!model.scenes.empty()) {
        const int chosen = std::max(model.defaultScene, 0);
        if (model.scenes.size() > 1) {
            document.warn(
                fmt::format("scenes[{}] of {} is drawn, the others are not", chosen, model.scenes.size()));
        }
        const std::vector<int>& roots = model.scenes[static_cast<std::size_t>(chosen)].nodes;
        if (roots.empty())
            throw file_error("has no nodes: the scene is empty",
                             fmt::format("{}: scenes[{}]", document.where, chosen));
        return roots;
    }
    document.warn("there are no scenes: all root nodes are drawn");
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty())
        throw file_error("every node is the child of another: a cycle", document.where + ": nodes");
    return roots;
}

}  // namespace

std::vector<PlacedNode> place_nodes(Document& document) {
    const std::vector<tinygltf::Node>& nodes = document.model->nodes;
    std::vector<bool> reached(nodes.size(), false);
    std::vector<PlacedNode> placed;
    const auto reach = [&](int node, const PlacedNode& parent) {
        const std::string place = fmt::format("{}: nodes[{}]", document.where, node);
        const auto i = static_cast<std::size_t>(node);
        if (reached[i]) throw file_error("is reached twice: a cycle, or a second parent", place);
        reached[i] = true;
        const glm::dmat4 world = parent.world_from_node * parent_from_node(nodes[i], place, document);
        if (!is_finite(world)) throw file_error("its transform is not finite", place);
        placed.push_back({node, world, parent.is_visible && is_visible(nodes[i]),
                          is_dynamic(document, node, parent.is_dynamic)});
    };
    for (const int root : root_nodes(document)) reach(root, {});
    // `placed` is the queue as well: breadth first.
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PlacedNode parent = placed[i];
        for (const int child : nodes[static_cast<std::size_t>(parent.node)].children) {
            reach(child, parent);
        }
    }
    return placed;
}

glm::dmat4 world_from_detached(Document& document, int node) {
    const std::vector<tinygltf::Node>& nodes = document.model->nodes;
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children)
            parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
    }
    glm::dmat4 world(1.0);
    std::size_t steps = 0;
    for (int at = node; at >= 0; at = parents[static_cast<std::size_t>(at)]) {
        const std::string place = fmt::format("{}: nodes[{}]", document.where, at);
        if (++steps > nodes.size()) throw file_error("is its own ancestor: a cycle", place);
        world = parent_from_node(nodes[static_cast<std::size_t>(at)], place, document) * world;
    }
    return world;
}

glm::dmat4 matrix_of_parts(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale,
                           Document& document) {
    const glm::dquat quaternion(rotation.w, rotation.x, rotation.y, rotation.z);
    const double length = glm::length(quaternion);
    glm::dmat4 result = glm::translate(glm::dmat4(1.0), translation);
    if (length > 1e-9 && std::isfinite(length)) {
        // Exporters round to a few digits; a larger difference gets a warning.
        if (std::abs(length - 1) > 1e-2)
            document.warn("rotations that are not unit quaternions are normalised");
        result *= glm::mat4_cast(quaternion / length);
    } else {
        document.warn("rotations of length 0 are taken as none");
    }
    return glm::scale(result, scale);
}

}  // namespace aoscore::gltf
