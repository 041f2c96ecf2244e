#include "importer/assimp_reader.h"

#include "core/error.h"
#include "core/files.h"
#include "importer/assimp_file.h"
#include "importer/assimp_materials.h"
#include "importer/fbx_settings.h"
#include "importer/fbx_visibility.h"
#include "importer/surface_builder.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore::importer {
namespace {

glm::dvec3 vector_of(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// Converts a matrix; Assimp stores them row by row.
glm::dmat4 matrix_of(const aiMatrix4x4& m) {
    glm::dmat4 matrix(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix[column][row] = m[static_cast<unsigned>(row)][static_cast<unsigned>(column)];
        }
    }
    return matrix;
}

/// Turns Assimp's meshes into those of the scene, each once however often it is placed.
class AssimpMeshes {
  public:
    AssimpMeshes(ImportJob& job, const aiScene& source, AssimpMaterials& materials, bool normals)
        : job_(job), source_(source), materials_(materials), normals_(normals) {}

    void place(unsigned mesh, const glm::dmat4& scene_from_node) {
        const auto [entry, is_new] = placed_.try_emplace(mesh);
        if (is_new) entry->second = convert(*source_.mMeshes[mesh]);
        if (!entry->second) return;
        job_.plain.scene.instances.push_back(
            {entry->second->first, glm::translate(scene_from_node, entry->second->second)});
    }

    void finish() {
        if (points_ > 0)
            job_.warn(fmt::format("{} points and lines are left out: they have no surface", points_));
    }

  private:
    using Placed =
        std::optional<std::pair<int, glm::dvec3>>;  // a mesh of the scene, and the origin of its positions

    Placed convert(const aiMesh& mesh) {
        const AssimpMaterials::Used& used = materials_.use(mesh.mMaterialIndex);
        const unsigned set = used.texture ? used.texture->texcoord_set : 0;
        const bool texcoords =
            used.texture && set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set);
        if (used.texture && !texcoords)
            job_.warn("meshes lack the texture coordinates that their material samples: taken as 0, 0");
        SurfaceBuilder builder({used.material, normals_ && mesh.HasNormals(), used.texture.has_value()});
        std::vector<Corner> corners;
        if (mesh.mNumFaces == 0) ++points_;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices < 3) {
                ++points_;
                continue;
            }
            corners.clear();
            for (unsigned i = 0; i < face.mNumIndices; ++i) {
                if (face.mIndices[i] >= mesh.mNumVertices)
                    refuse_index(face.mIndices[i], mesh.mNumVertices, f);
                corners.push_back(corner_of(mesh, face.mIndices[i], texcoords ? &*used.texture : nullptr));
            }
            builder.add(corners, f + 1);
        }
        if (builder.empty()) return std::nullopt;
        SurfaceBuilder::Built built = builder.take();
        warn_of_losses(mesh, built.centre);
        std::vector<Mesh>& meshes = job_.plain.scene.meshes;
        meshes.push_back(std::move(built.mesh));
        return {{static_cast<int>(meshes.size()) - 1, built.centre}};
    }

    void warn_of_losses(const aiMesh& mesh, const glm::dvec3& centre) {
        if (centre != glm::dvec3(0))
            job_.warn(
                "meshes lie far from their origin for their size: read in float32, details are lost there");
        if (mesh.mNumBones > 0 || mesh.mNumAnimMeshes > 0)
            job_.warn("meshes with bones or blend shapes are drawn as they are stored, without a pose");
        bool has_alpha = false;
        for (unsigned i = 0; mesh.HasVertexColors(0) && i < mesh.mNumVertices; ++i)
            has_alpha |= mesh.mColors[0][i].a < 0.5f;
        if (has_alpha) job_.warn("vertex colours have an alpha below 0.5: drawn solid");
    }

    [[noreturn]] static void refuse_index(unsigned index, unsigned count, unsigned face) {
        throw file_error(fmt::format("names vertex {} of {}", index, count),
                         fmt::format("face {}", face + 1));
    }

    Corner corner_of(const aiMesh& mesh, unsigned vertex, const TextureUse* texture) const {
        Corner corner;
        corner.position = vector_of(mesh.mVertices[vertex]);
        if (normals_ && mesh.HasNormals()) corner.normal = vector_of(mesh.mNormals[vertex]);
        if (texture != nullptr) {
            const aiVector3D& source = mesh.mTextureCoords[texture->texcoord_set][vertex];
            const glm::vec2 uv = glm::vec2(source.x, source.y) * texture->scale + texture->offset;
            corner.texcoord = {uv.x, 1 - uv.y};
        }
        return corner;
    }

    ImportJob& job_;
    const aiScene& source_;
    AssimpMaterials& materials_;
    bool normals_;
    std::map<unsigned, Placed> placed_;
    std::size_t points_ = 0;
};

/// Walks the nodes without recursion: a file may nest them as deep as it likes.
template <class Visit>
void for_each_node(const aiScene& scene, Visit visit) {
    std::vector<std::pair<const aiNode*, glm::dmat4>> open{{scene.mRootNode, glm::dmat4(1.0)}};
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const glm::dmat4 scene_from_node = parent * matrix_of(node->mTransformation);
        visit(*node, scene_from_node);
        for (unsigned i = node->mNumChildren; i-- > 0;)
            open.emplace_back(node->mChildren[i], scene_from_node);
    }
}

/// Warns of nodes that other programs hide, who do not agree on which, nor on whether their children go with
/// them.
void warn_of_hidden_nodes(ImportJob& job, const aiScene& scene) {
    std::size_t hidden = count_invisible_nodes(read_file(job.file, AssimpFile::kMaxBytes));
    for_each_node(scene, [&](const aiNode& node, const glm::dmat4&) {
        bool is_shown = true;
        if (node.mNumMeshes > 0 && node.mMetaData != nullptr && node.mMetaData->Get("Show", is_shown) &&
            !is_shown)
            ++hidden;
    });
    if (hidden > 0)
        job.warn(
            fmt::format("{} nodes are hidden in the file (Show or Visibility): drawn all the same", hidden));
}

void read_surfaces(ImportJob& job, const aiScene& scene, bool normals) {
    AssimpMaterials materials(job, scene);
    AssimpMeshes meshes(job, scene, materials, normals);
    for_each_node(scene, [&](const aiNode& node, const glm::dmat4& scene_from_node) {
        for (unsigned i = 0; i < node.mNumMeshes; ++i) meshes.place(node.mMeshes[i], scene_from_node);
    });
    meshes.finish();
    materials.finish();
}

}  // namespace

void read_fbx(ImportJob& job) {
    const AssimpFile file(job.file, "fbx");
    read_surfaces(job, file.scene(), true);
    read_fbx_settings(job, file.scene());
    warn_of_hidden_nodes(job, file.scene());
    if (file.scene().mNumCameras > 0) {
        job.warn(fmt::format("{} cameras are not read: give your own with --views or --eye",
                             file.scene().mNumCameras));
    }
}

void read_stl(ImportJob& job) {
    read_surfaces(job, AssimpFile(job.file, "stl").scene(), false);
}

}  // namespace aoscore::importer
