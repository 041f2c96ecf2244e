#include "screen/gbuffer/scene_geometry.h"

#include "core/error.h"

#include <fmt/format.h>
#include <glm/ext/vector_float1.hpp>

#include <algorithm>
#include <limits>

namespace aoscore {
namespace {

// The locations of attributes in shaders/gbuffer/scene.vert.
constexpr GLuint kPosition = 0, kNormal = 1, kTexcoord = 2, kAlpha = 3;

struct Vertices {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec1> alphas;  // empty where no mesh has any
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec4> triangle_normals;
};

void append(Vertices& all, const Mesh& mesh) {
    const auto end = all.positions.size() + mesh.positions.size();
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
    all.texcoords.insert(all.texcoords.end(), mesh.texcoords.begin(), mesh.texcoords.end());
    // A mesh without normals is drawn flat: a zero normal tells the shader so.
    all.normals.resize(end, glm::vec3(0));
    all.texcoords.resize(end, glm::vec2(0));
    if (!mesh.alphas.empty()) {
        all.alphas.resize(end - mesh.positions.size(), glm::vec1(1));
        for (const float alpha : mesh.alphas) all.alphas.emplace_back(alpha);
    }
    all.triangles.insert(all.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 normal =
            triangle_normal(glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                            glm::dvec3(mesh.positions[t.z]));
        all.triangle_normals.emplace_back(glm::vec3(normal), 0.0F);
    }
}

template <class T>
gl::Buffer upload(GLenum target, const std::vector<T>& data) {
    gl::Buffer buffer = gl::Buffer::create();
    gl::BindBuffer(target, buffer.name());
    gl::BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    return buffer;
}

template <class T>
gl::Buffer upload_attribute(GLuint place, const std::vector<T>& data) {
    gl::Buffer buffer = upload(GL_ARRAY_BUFFER, data);
    gl::VertexAttribPointer(place, T::length(), GL_FLOAT, GL_FALSE, 0, nullptr);
    gl::EnableVertexAttribArray(place);
    return buffer;
}

gl::Texture upload_texture(const Texture& texture) {
    gl::Texture result;
    if (texture.texels.empty()) return result;
    result = gl::Texture::create();
    gl::BindTexture(GL_TEXTURE_2D, result.name());
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl::TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.texels.width, texture.texels.height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, texture.texels.pixels.data());
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return result;
}

void check_size(const Vertices& all) {
    GLint texels = 0;
    gl::GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    if (all.triangle_normals.size() > static_cast<std::size_t>(texels) ||
        all.positions.size() > static_cast<std::size_t>(std::numeric_limits<GLint>::max())) {
        throw file_error(fmt::format("{} triangles are more than the rasteriser takes", all.triangles.size()),
                         "scene", fmt::format("at most {}", texels));
    }
}

}  // namespace

SceneGeometry::SceneGeometry(const Scene& scene) : materials_(scene.materials) {
    Vertices all;
    for (const Mesh& mesh : scene.meshes) {
        ranges_.push_back({mesh.material, static_cast<GLint>(all.positions.size()),
                           static_cast<GLsizei>(mesh.triangles.size() * 3),
                           all.triangles.size() * sizeof(glm::uvec3),
                           static_cast<GLint>(all.triangles.size())});
        append(all, mesh);
    }
    check_size(all);

    vertex_array_ = gl::VertexArray::create();
    gl::BindVertexArray(vertex_array_.name());
    positions_ = upload_attribute(kPosition, all.positions);
    normals_ = upload_attribute(kNormal, all.normals);
    texcoords_ = upload_attribute(kTexcoord, all.texcoords);
    if (all.alphas.empty()) {
        gl::VertexAttrib1f(kAlpha, 1.0F);
    } else {
        all.alphas.resize(all.positions.size(), glm::vec1(1));
        alphas_ = upload_attribute(kAlpha, all.alphas);
    }
    indices_ = upload(GL_ELEMENT_ARRAY_BUFFER, all.triangles);
    gl::BindVertexArray(0);

    normal_texels_ = upload(GL_TEXTURE_BUFFER, all.triangle_normals);
    triangle_normals_ = gl::Texture::create();
    gl::BindTexture(GL_TEXTURE_BUFFER, triangle_normals_.name());
    gl::TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, normal_texels_.name());

    for (const Texture& texture : scene.textures) {
        textures_.push_back(upload_texture(texture));
        Texture info;
        info.texels.width = texture.texels.width;
        info.texels.height = texture.texels.height;
        info.wrap_s = texture.wrap_s;
        info.wrap_t = texture.wrap_t;
        texture_infos_.push_back(std::move(info));
    }

    for (const Instance& instance : scene.instances)
        draws_.push_back({instance.mesh, static_cast<int>(draws_.size()), instance.scene_from_mesh,
                          instance.is_dynamic});
    std::stable_partition(draws_.begin(), draws_.end(), [&](const Draw& draw) {
        const int material = ranges_[static_cast<std::size_t>(draw.range)].material;
        return !materials_[static_cast<std::size_t>(material)].is_cutout();
    });
    gl::check("uploading the scene");
}

}  // namespace aoscore
