#include "scene/gltf/load_gltf.h"

#include "core/error.h"
#include "scene/gltf/cameras.h"
#include "scene/gltf/document.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/meshes.h"
#include "scene/gltf/nodes.h"
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

/// Whether a transform flattens the mesh (a scale of zero): it has no inverse then, and no normals follow
/// from it.
bool flattens(const glm::dmat4& m) {
    constexpr double kFlat = 1e-10;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double longest = std::max({glm::length(x), glm::length(y), glm::length(z)});
    return !(std::abs(glm::determinant(glm::dmat3(m))) > kFlat * longest * longest * longest);
}

/// Places decoded meshes in the scene.
class InstanceBuilder {
  public:
    InstanceBuilder(Document& document, MeshReader& reader, Scene& scene)
        : document_(document), reader_(reader), scene_(scene) {}

    void add(int gltf_mesh, const glm::dmat4& world_from_node) {
        const auto [known, is_new] = decoded_.try_emplace(gltf_mesh);
        if (is_new) {
            for (DecodedMesh& decoded : reader_.read(gltf_mesh)) {
                known->second.push_back({static_cast<int>(scene_.meshes.size()), decoded.centre});
                scene_.meshes.push_back(std::move(decoded.mesh));
            }
        }
        for (const auto& [mesh, centre] : known->second) {
            const glm::dmat4 world_from_mesh = glm::translate(world_from_node, centre);
            if (flattens(world_from_mesh)) {
                add_flattened(mesh, world_from_mesh);
            } else {
                scene_.instances.push_back({mesh, world_from_mesh});
            }
        }
    }

  private:
    struct PlacedMesh {
        int mesh;
        glm::dvec3 centre;
    };

    /// A flattened mesh becomes one of its own, with what is left of its triangles and no normals.
    void add_flattened(int mesh_index, const glm::dmat4& world_from_mesh) {
        document_.warn(
            "nodes with a scale of 0 flatten their meshes: drawn with flat normals where any area is left");
        const Mesh& source = scene_.meshes[static_cast<std::size_t>(mesh_index)];
        document_.budget.take(
            source.positions.size() * sizeof(glm::vec3) + source.triangles.size() * sizeof(glm::uvec3),
            document_.where + ": nodes");
        Mesh flat;
        flat.texcoords = source.texcoords;
        flat.triangles = source.triangles;
        flat.material = source.material;
        const glm::dvec3 place(world_from_mesh[3]);
        for (const glm::vec3& p : source.positions) {
            flat.positions.emplace_back(glm::dmat3(world_from_mesh) * glm::dvec3(p));
        }
        drop_degenerate_triangles(flat);
        if (flat.triangles.empty()) return;
        scene_.instances.push_back(
            {static_cast<int>(scene_.meshes.size()), glm::translate(glm::dmat4(1.0), place)});
        scene_.meshes.push_back(std::move(flat));
    }

    Document& document_;
    MeshReader& reader_;
    Scene& scene_;
    std::map<int, std::vector<PlacedMesh>> decoded_;
};

}  // namespace

Scene load_gltf(const std::filesystem::path& file, const LoadOptions& options) {
    const std::unique_ptr<Document> document = open_document(file);
    const std::vector<PlacedNode> nodes = place_nodes(*document);
    MaterialTable materials = read_materials(*document, options.albedo_textures);

    Scene scene;
    scene.file = file;
    MeshReader reader(*document, materials);
    InstanceBuilder instances(*document, reader, scene);
    for (const PlacedNode& placed : nodes) {
        const int mesh = document->model->nodes[static_cast<std::size_t>(placed.node)].mesh;
        if (mesh >= 0) instances.add(mesh, placed.world_from_node);
    }
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
    measure_scene(scene, document->where);
    scene.views = read_cameras(*document, nodes, scene.bounds);
    scene.warnings = std::move(document->warnings);
    return scene;
}

}  // namespace aoscore::gltf
