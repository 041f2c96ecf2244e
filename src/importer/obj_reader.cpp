#include "importer/obj_reader.h"

#include "core/error.h"
#include "core/files.h"
#include "importer/mtl_library.h"
#include "importer/obj_text.h"
#include "importer/surface_builder.h"
#include "importer/tiny_obj.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <map>
#include <span>
#include <streambuf>
#include <vector>

namespace aoscore::importer {
namespace {

/// Objects smaller than this share meshes: a file may have a group for each of its triangles.
constexpr std::size_t kTrianglesOfAnObject = 4096;

constexpr std::size_t kMaxObjBytes = std::size_t{4} << 30;

/// A text in memory as a stream, without a copy.
class TextBuffer : public std::streambuf {
  public:
    explicit TextBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

std::string trimmed_name(const char* name) {
    const std::string text(name);
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Builds meshes from the statements that tinyobjloader finds, in the order of the file.
class ObjAssembly {
  public:
    explicit ObjAssembly(ImportJob& job, MtlLibrary& materials) : job_(job), materials_(materials) {}

    void add_position(const glm::dvec3& p) { positions_.push_back(p); }
    void add_normal(const glm::dvec3& n) { normals_.emplace_back(n); }
    void add_texcoord(const glm::dvec2& uv) { texcoords_.push_back(uv); }
    void use_material(std::string name) { material_ = std::move(name); }

    void add_face(std::span<const tinyobj::index_t> indices) {
        ++faces_;
        if (indices.size() < 3) {
            ++lines_;
            return;
        }
        const MtlLibrary::Used& used = materials_.use(material_);
        SurfaceBuilder::Attributes attributes{used.material, true, used.texture.has_value()};
        corners_.clear();
        for (const tinyobj::index_t& index : indices) {
            Corner& corner = corners_.emplace_back();
            corner.position = positions_[resolve(index.vertex_index, positions_.size(), "position")];
            if (index.normal_index == 0) {
                attributes.normals = false;
            } else {
                corner.normal = normals_[resolve(index.normal_index, normals_.size(), "normal")];
            }
            if (used.texture) corner.texcoord = texcoord(index.texcoord_index, *used.texture);
        }
        if (!attributes.normals) {
            for (Corner& corner : corners_) corner.normal = glm::vec3(0);
        }
        builders_.try_emplace(attributes, attributes).first->second.add(corners_, faces_);
    }

    /// Called where an object or a group begins: large ones before it become meshes of their own.
    void begin_object() {
        for (auto& [attributes, builder] : builders_) {
            if (builder.triangle_count() >= kTrianglesOfAnObject) place_mesh(builder);
        }
    }

    void finish() {
        for (auto& [attributes, builder] : builders_) {
            if (!builder.empty()) place_mesh(builder);
        }
        if (lines_ > 0) job_.warn(fmt::format("{} faces of fewer than three corners are left out", lines_));
        if (without_texcoord_ > 0) {
            job_.warn(fmt::format(
                "{} corners lack the texture coordinates that their material samples: taken as 0, 0",
                without_texcoord_));
        }
    }

  private:
    /// Resolves an index: OBJ counts from 1, or with a negative number back from the last statement.
    std::size_t resolve(int index, std::size_t count, const char* what) const {
        const auto there = static_cast<long>(count);
        const long resolved = index > 0 ? index - 1L : there + index;
        if (index == 0 || resolved < 0 || resolved >= there) {
            throw file_error(fmt::format("names {} {}", what, index), fmt::format("face {}", faces_),
                             fmt::format("1 to {0}, or -{0} to -1", there));
        }
        return static_cast<std::size_t>(resolved);
    }

    glm::vec2 texcoord(int index, const TextureUse& use) {
        if (index == 0) {
            ++without_texcoord_;
            return glm::vec2(0);
        }
        const glm::vec2 uv =
            texcoords_[resolve(index, texcoords_.size(), "texture coordinate")] * use.scale + use.offset;
        return {uv.x, 1 - uv.y};
    }

    void place_mesh(SurfaceBuilder& builder) {
        SurfaceBuilder::Built built = builder.take();
        Scene& scene = job_.plain.scene;
        scene.instances.push_back(
            {static_cast<int>(scene.meshes.size()), glm::translate(glm::dmat4(1.0), built.centre)});
        scene.meshes.push_back(std::move(built.mesh));
    }

    ImportJob& job_;
    MtlLibrary& materials_;
    std::vector<glm::dvec3> positions_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec2> texcoords_;
    std::string material_;
    std::map<SurfaceBuilder::Attributes, SurfaceBuilder> builders_;
    std::vector<Corner> corners_;
    std::size_t faces_ = 0, lines_ = 0, without_texcoord_ = 0;
};

ObjAssembly& assembly(void* user) {
    return *static_cast<ObjAssembly*>(user);
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* user, double x, double y, double z, double) {
        assembly(user).add_position({x, y, z});
    };
    calls.normal_cb = [](void* user, double x, double y, double z) { assembly(user).add_normal({x, y, z}); };
    calls.texcoord_cb = [](void* user, double u, double v, double) { assembly(user).add_texcoord({u, v}); };
    calls.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        assembly(user).add_face({indices, static_cast<std::size_t>(count)});
    };
    calls.usemtl_cb = [](void* user, const char* name, int) {
        assembly(user).use_material(trimmed_name(name));
    };
    calls.group_cb = [](void* user, const char**, int) { assembly(user).begin_object(); };
    calls.object_cb = [](void* user, const char*) { assembly(user).begin_object(); };
    return calls;
}

}  // namespace

void read_obj(ImportJob& job) {
    ObjText text = prepare_obj(read_file(job.file, kMaxObjBytes));
    if (text.curves > 0)
        job.warn(fmt::format("{} curves and surfaces of free form are left out: only polygons are read",
                             text.curves));
    MtlLibrary materials(job, text.libraries);
    ObjAssembly obj(job, materials);
    TextBuffer buffer(text.statements);
    std::istream in(&buffer);
    tinyobj::LoadObjWithCallback(in, callbacks(), &obj);
    obj.finish();
    materials.finish();
}

}  // namespace aoscore::importer
