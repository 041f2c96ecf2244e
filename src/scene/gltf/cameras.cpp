#include "scene/gltf/cameras.h"

#include "scene/depth_range.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

namespace aoscore::gltf {
namespace {

/// A node's name as an id of the command line: letters, digits, '_', '-', '.'; unique among `taken`.
std::string view_id(const std::string& name, std::set<std::string>& taken) {
    constexpr std::size_t kMaxLength = 64;
    std::string id = name.empty() ? "camera" : name.substr(0, kMaxLength);
    for (char& c : id) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-' && c != '.') c = '_';
    }
    std::string unique = id;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = fmt::format("{}_{}", id, n);
    return unique;
}

/// The camera of a node. Its target is a unit of length away, or nearer where the whole scene is smaller than
/// that.
std::optional<Camera> camera_at(const glm::dmat4& world_from_node, const Bounds& bounds) {
    const glm::dvec3 x(world_from_node[0]), up(world_from_node[1]), back(world_from_node[2]);
    const double lengths = glm::length(x) * glm::length(up) * glm::length(back);
    if (!(lengths > 0) || glm::length(glm::cross(up, back)) < 1e-9 * glm::length(up) * glm::length(back)) {
        return std::nullopt;
    }
    Camera camera;
    camera.position = glm::dvec3(world_from_node[3]);
    const double diagonal = bounds.diagonal();
    camera.target = camera.position - glm::normalize(back) * (diagonal > 0 ? std::min(1.0, diagonal) : 1.0);
    camera.up = glm::normalize(up);
    return camera;
}

void set_lens(Camera& camera, const tinygltf::Camera& source, const Bounds& bounds, Document& document,
              const std::string& place) {
    double stated_near = 0, stated_far = 0;
    if (source.type == "perspective") {
        camera.projection = Camera::Projection::perspective;
        camera.fovy_rad = source.perspective.yfov;
        stated_near = source.perspective.znear;
        stated_far = source.perspective.zfar;
    } else {
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = std::abs(source.orthographic.ymag);
        stated_near = source.orthographic.znear;
        stated_far = source.orthographic.zfar;
    }
    // A node's scale does not apply to cameras: in a scene that was scaled down, all of it may lie before
    // their near planes.
    if (glm::distance(camera.position, bounds.centre()) + bounds.diagonal() / 2 < stated_near) {
        document.warn(fmt::format("{}: znear {:.3g} m lies beyond all of the scene and is not used", place,
                                  stated_near));
        stated_near = 0;
    }
    const DepthRange range = useful_depth_range(camera, bounds, stated_near, stated_far);
    camera.near = range.near;
    camera.far = range.far;
    if (camera.projection == Camera::Projection::perspective && stated_near > 0 && range.near > stated_near) {
        document.warn(
            fmt::format("{}: znear {:.3g} m is raised to {:.3g} m, or depth would lose its precision", place,
                        stated_near, range.near));
    }
}

}  // namespace

std::vector<View> read_cameras(Document& document, const std::vector<PlacedNode>& nodes,
                               const Bounds& bounds) {
    std::vector<View> views;
    std::set<std::string> taken;
    for (const PlacedNode& placed : nodes) {
        const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
        if (node.camera < 0) continue;
        const tinygltf::Camera& source = document.model->cameras[static_cast<std::size_t>(node.camera)];
        const std::string place = fmt::format("nodes[{}]", placed.node);
        auto camera = camera_at(placed.world_from_node, bounds);
        if (!camera) {
            document.warn(place + ": its camera is scaled to nothing and left out");
            continue;
        }
        if (glm::determinant(glm::dmat3(placed.world_from_node)) < 0) {
            document.warn(place + ": its camera is mirrored, its picture is not");
        }
        set_lens(*camera, source, bounds, document, place);
        View view;
        view.id = view_id(node.name.empty() ? source.name : node.name, taken);
        view.camera = *camera;
        view.kind = View::Kind::node;
        view.source = "camera node " + (node.name.empty() ? place : printable(node.name));
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace aoscore::gltf
