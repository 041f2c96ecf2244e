#include "scene/gltf/load_gltf.h"

#include "core/error.h"
#include "scene/gltf/cameras.h"
#include "scene/gltf/document.h"
#include "scene/gltf/instancing.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/meshes.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/solid_cutouts.h"
#include "scene/mesh_repair.h"
#include "scene/scene_bounds.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace aoscore::gltf {
namespace {

/// Whether a transform flattens the mesh (a scale of zero): it then has no inverse, and gives no normals.
bool flattens(const glm::dmat4& m) {
    constexpr double kFlat = 1e-10;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double longest = std::max({glm::length(x), glm::length(y), glm::length(z)});
    return !(std::abs(glm::determinant(glm::dmat3(m))) > kFlat * longest * longest * longest);
}

/// Places decoded meshes in the scene.
class InstanceBuilder {
  public:
    InstanceBuilder(Document& document, const Skins& skins, MeshReader& reader, Scene& scene)
        : document_(document), skins_(skins), reader_(reader), scene_(scene) {}

    void add(const PlacedNode& placed) {
        const tinygltf::Node& node = document_.model->nodes[static_cast<std::size_t>(placed.node)];
        if (node.mesh < 0 || !placed.is_visible) return;
        const Pose pose = pose_of(document_, node);
        const std::vector<PlacedMesh>& meshes = decoded(node.mesh, pose);
        const bool is_dynamic = placed.is_dynamic || (pose.skin >= 0 && skins_.is_dynamic(pose.skin));
        const std::string place = fmt::format("{}: nodes[{}]", document_.where, placed.node);
        const std::vector<glm::dmat4> instances = node_from_instances(document_, node, place);
        if (pose.skin >= 0) {
            if (instances.size() > 1)
                document_.warn("instances of skinned meshes (not defined by glTF) are drawn once");
            for (const PlacedMesh& mesh : meshes) add({mesh.mesh, glm::dmat4(1.0), is_dynamic}, mesh.centre);
            return;
        }
        for (const glm::dmat4& node_from_instance : instances) {
            const glm::dmat4 world_from_node = placed.world_from_node * node_from_instance;
            for (const PlacedMesh& mesh : meshes) add({mesh.mesh, world_from_node, is_dynamic}, mesh.centre);
        }
    }

  private:
    struct PlacedMesh {
        int mesh;
        glm::dvec3 centre;
    };

    const std::vector<PlacedMesh>& decoded(int gltf_mesh, const Pose& pose) {
        const auto [known, is_new] = decoded_.try_emplace({gltf_mesh, pose});
        if (is_new) {
            for (DecodedMesh& decoded : reader_.read(gltf_mesh, pose)) {
                known->second.push_back({static_cast<int>(scene_.meshes.size()), decoded.centre});
                scene_.meshes.push_back(std::move(decoded.mesh));
            }
        }
        return known->second;
    }

    /// Adds an instance of a mesh whose positions are relative to `centre`.
    void add(Instance instance, const glm::dvec3& centre) {
        instance.scene_from_mesh = glm::translate(instance.scene_from_mesh, centre);
        if (flattens(instance.scene_from_mesh)) {
            add_flattened(instance);
        } else {
            scene_.instances.push_back(instance);
        }
    }

    /// Adds a flattened mesh as a mesh of its own, with the triangles that keep an area and no normals.
    void add_flattened(const Instance& instance) {
        document_.warn(
            "nodes with a scale of 0 flatten their meshes: drawn with flat normals where any area is left");
        const glm::dmat4& world_from_mesh = instance.scene_from_mesh;
        if (glm::dmat3(world_from_mesh) == glm::dmat3(0.0)) return;
        const Mesh& source = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
        document_.budget.take(
            source.positions.size() * sizeof(glm::vec3) + source.triangles.size() * sizeof(glm::uvec3),
            document_.where + ": nodes");
        Mesh flat;
        flat.texcoords = source.texcoords;
        flat.alphas = source.alphas;
        flat.triangles = source.triangles;
        flat.material = source.material;
        const glm::dvec3 place(world_from_mesh[3]);
        for (const glm::vec3& p : source.positions) {
            flat.positions.emplace_back(glm::dmat3(world_from_mesh) * glm::dvec3(p));
        }
        drop_degenerate_triangles(flat);
        if (flat.triangles.empty()) return;
        scene_.instances.push_back({static_cast<int>(scene_.meshes.size()),
                                    glm::translate(glm::dmat4(1.0), place), instance.is_dynamic});
        scene_.meshes.push_back(std::move(flat));
    }

    Document& document_;
    const Skins& skins_;
    MeshReader& reader_;
    Scene& scene_;
    std::map<std::pair<int, Pose>, std::vector<PlacedMesh>> decoded_;
};

}  // namespace

Scene load_gltf(const std::filesystem::path& file, const LoadOptions& options) {
    const std::unique_ptr<Document> document = open_document(file);
    const std::vector<PlacedNode> nodes = place_nodes(*document);
    MaterialTable materials = read_materials(*document, options.albedo_textures);

    Scene scene;
    scene.file = file;
    Skins skins(*document, nodes);
    MeshReader reader(*document, materials, skins);
    InstanceBuilder instances(*document, skins, reader, scene);
    for (const PlacedNode& placed : nodes) instances.add(placed);
    if (reader.degenerate_triangles() > 0) {
        document->warn(fmt::format("{} triangles without area are left out", reader.degenerate_triangles()));
    }
    if (scene.instances.empty()) {
        std::string why;
        for (const std::string& warning : document->warnings) why += (why.empty() ? "" : "; ") + warning;
        throw file_error(
            "has no usable geometry: no triangle with an area" + (why.empty() ? "" : " (" + why + ")"),
            document->where);
    }
    scene.materials = std::move(materials.materials);
    scene.textures = std::move(materials.textures);
    make_uncut_solid(scene, options.albedo_textures);
    measure_scene(scene, document->where);
    scene.views = read_cameras(*document, nodes, scene.bounds);
    scene.warnings = std::move(document->warnings);
    return scene;
}

}  // namespace aoscore::gltf
