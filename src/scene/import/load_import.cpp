#include "scene/import/load_import.h"

#include "core/error.h"
#include "core/processes/child_process.h"
#include "core/processes/program_path.h"
#include "scene/gltf/place.h"
#include "scene/mesh_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <string>
#include <vector>

namespace aoscore::imported {

namespace fs = std::filesystem;

namespace {

/// The error that says why the program ended without a whole scene.
Error failure(const ChildProcess::End& end, const std::string& where) {
    constexpr const char* kValid = "a file that another program can open, or its conversion to glTF";
    if (end.signal == SIGXCPU)
        return file_error("takes longer to read than a file of its size may: it is broken or endless", where,
                          kValid);
    if (end.signal != 0) {
        return file_error(
            fmt::format("crashes its reader ({}): it is broken, or the reader is", strsignal(end.signal)),
            where, kValid);
    }
    return file_error("needs more memory than a file of its size may take, or its reader failed", where,
                      kValid);
}

PlainScene read_in_child(const fs::path& file, bool albedo_textures) {
    std::vector<std::string> arguments{fs::absolute(file).string()};
    if (albedo_textures) arguments.emplace_back("--albedo");
    ChildProcess child(beside_program("aoscore-import"), arguments);
    std::optional<PlainScene> plain =
        read_plain_scene([&child](void* to, std::size_t size) { return child.read(to, size); });
    if (!plain) throw failure(child.wait(), gltf::printable(file.string()));
    return std::move(*plain);
}

/// Whether a transform flattens its mesh, so that it gives no normals.
bool flattens(const glm::dmat4& m) {
    constexpr double kFlat = 1e-10;
    const double longest = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    return !(std::abs(glm::determinant(glm::dmat3(m))) > kFlat * longest * longest * longest);
}

/// Leaves out meshes without triangles, and instances without volume.
void drop_unseen(Scene& scene) {
    std::vector<int> new_index;
    std::vector<Mesh> kept;
    for (Mesh& mesh : scene.meshes) {
        new_index.push_back(mesh.triangles.empty() ? -1 : static_cast<int>(kept.size()));
        if (!mesh.triangles.empty()) kept.push_back(std::move(mesh));
    }
    scene.meshes = std::move(kept);
    for (Instance& instance : scene.instances)
        instance.mesh = new_index[static_cast<std::size_t>(instance.mesh)];
    std::erase_if(scene.instances, [](const Instance& instance) { return instance.mesh < 0; });
    const std::size_t flat = std::erase_if(
        scene.instances, [](const Instance& instance) { return flattens(instance.scene_from_mesh); });
    if (flat > 0)
        scene.warnings.push_back(fmt::format("{} meshes that a scale of 0 flattens are left out", flat));
}

/// Leaves out triangles without area and makes normals unit; warns with their numbers.
void repair(Scene& scene) {
    std::size_t degenerate = 0, bad_normals = 0;
    for (Mesh& mesh : scene.meshes) {
        degenerate += drop_degenerate_triangles(mesh);
        bad_normals += repair_normals(mesh);
    }
    if (degenerate > 0)
        scene.warnings.push_back(fmt::format("{} triangles without area are left out", degenerate));
    if (bad_normals > 0) {
        scene.warnings.push_back(
            fmt::format("{} vertex normals are zero or not finite: taken from the faces", bad_normals));
    }
    drop_unseen(scene);
}

std::string words(const std::vector<std::string>& warnings) {
    std::string text;
    for (const std::string& warning : warnings) text += (text.empty() ? " (" : "; ") + warning;
    return text.empty() ? text : text + ")";
}

}  // namespace

PlainScene load_import(const fs::path& file, Format format, bool albedo_textures) {
    const std::string where = gltf::printable(file.string());
    PlainScene plain = read_in_child(file, albedo_textures);
    if (!plain.refusal.empty()) throw file_error(plain.refusal, where);
    repair(plain.scene);
    if (plain.scene.instances.empty()) {
        throw file_error("has no usable geometry: no triangle with an area" + words(plain.scene.warnings),
                         where, fmt::format("{} with faces", format_name(format)));
    }
    plain.scene.file = file;
    return plain;
}

}  // namespace aoscore::imported
