#include "screen/gbuffer/scene_drawing.h"

#include "core/folders.h"
#include "scene/cofactors.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

// Texture units.
constexpr GLenum kBaseColor = 0, kTriangleNormals = 1, kLayerBefore = 2;

// Normals transform by the cofactor matrix, which exists for flattened instances too. Its sign does not
// matter: normals are turned to the camera. They are scaled to keep float in range.
glm::mat3 normal_matrix(const glm::dmat4& view_from_mesh) {
    glm::dmat3 matrix = cofactors(glm::dmat3(view_from_mesh));
    double largest = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    }
    if (largest > 0) matrix /= largest;
    return glm::mat3(matrix);
}

GLint wrap_mode(Texture::Wrap wrap) {
    return static_cast<GLint>(wrap);
}

const SceneGeometry::Range& range_of(const SceneGeometry& geometry, const SceneGeometry::Draw& draw) {
    return geometry.ranges()[static_cast<std::size_t>(draw.range)];
}

const Material& material_of(const SceneGeometry& geometry, const SceneGeometry::Draw& draw) {
    return geometry.materials()[static_cast<std::size_t>(range_of(geometry, draw).material)];
}

struct MeshPlace {
    const SceneGeometry& geometry;
    const SceneGeometry::Draw& draw;
    const glm::dmat4& view_from_scene;
};

void draw_mesh(const MeshPlace& place, const ShaderProgram& p) {
    const SceneGeometry& geometry = place.geometry;
    const SceneGeometry::Range& range = range_of(geometry, place.draw);
    const Material& material = material_of(geometry, place.draw);
    const glm::dmat4 view_from_mesh = place.view_from_scene * place.draw.scene_from_mesh;
    gl::UniformMatrix4fv(p.location("u_view_from_mesh"), 1, GL_FALSE,
                         glm::value_ptr(glm::mat4(view_from_mesh)));
    gl::UniformMatrix3fv(p.location("u_normal_from_mesh"), 1, GL_FALSE,
                         glm::value_ptr(normal_matrix(view_from_mesh)));
    gl::Uniform1i(p.location("u_first_triangle"), range.first_triangle);
    gl::Uniform1i(p.location("u_instance"), place.draw.instance);
    gl::Uniform1i(p.location("u_is_dynamic"), place.draw.is_dynamic ? 1 : 0);
    gl::Uniform1f(p.location("u_alpha_cutoff"), material.alpha_cutoff);
    gl::Uniform4fv(p.location("u_base_color_factor"), 1, glm::value_ptr(material.base_color));
    const bool textured = material.texture >= 0 && geometry.texture(material.texture) != 0;
    gl::Uniform1i(p.location("u_has_texture"), textured ? 1 : 0);
    if (textured) {
        const Texture& info = geometry.texture_info(material.texture);
        gl::Uniform2i(p.location("u_wrap"), wrap_mode(info.wrap_s), wrap_mode(info.wrap_t));
        gl::BindTexture(GL_TEXTURE_2D, geometry.texture(material.texture));
    }
    gl::DrawElementsBaseVertex(GL_TRIANGLES, range.index_count, GL_UNSIGNED_INT,
                               static_cast<const char*>(nullptr) + range.index_offset, range.base_vertex);
}

}  // namespace

const ShaderProgram& SceneDrawing::program(const Look& look, bool orthographic, bool cutout) {
    std::string macros = fmt::format("#define ORTHOGRAPHIC {}\n", orthographic ? 1 : 0);
    if (cutout) macros += "#define CUTOUT\n";
    if (look.layer_before != 0) macros += "#define PEELED\n";
    macros += look.macros;
    const auto found = programs_.find(macros);
    if (found != programs_.end()) return found->second;
    const auto folder = data_dir() / "shaders" / "gbuffer";
    ShaderSource vertex, fragment;
    vertex.add_block(fmt::format("({}'s macros)", name_), macros);
    vertex.add_file(folder / "scene.vert", folder);
    fragment.add_block(fmt::format("({}'s macros)", name_), macros);
    fragment.add_file(folder / fragment_, folder);
    return programs_.emplace(macros, ShaderProgram(name_, vertex, fragment)).first->second;
}

void SceneDrawing::begin(const Look& look, const ShaderProgram& p, const ViewUniforms& view) const {
    glm::dmat4 clip_from_view = look.frame->clip_from_view();
    clip_from_view[1] *= -1.0;  // row 0 at the top
    p.use();
    view.set(p);
    gl::UniformMatrix4fv(p.location("u_clip_from_view"), 1, GL_FALSE,
                         glm::value_ptr(glm::mat4(clip_from_view)));
    gl::Uniform1i(p.location("u_base_color_texture"), kBaseColor);
    gl::Uniform1i(p.location("u_triangle_normals"), kTriangleNormals);
    gl::Uniform1i(p.location("u_layer_before"), kLayerBefore);
    if (look.set_uniforms) look.set_uniforms(p);
}

void SceneDrawing::draw(const Look& look) {
    const ViewUniforms view(*look.frame);
    const glm::dmat4 view_from_scene = look.frame->view_from_world();
    gl::Viewport(0, 0, view.width, view.height);
    gl::BindVertexArray(look.geometry->vertex_array());
    gl::ActiveTexture(GL_TEXTURE0 + kLayerBefore);
    gl::BindTexture(GL_TEXTURE_2D, look.layer_before);
    gl::ActiveTexture(GL_TEXTURE0 + kTriangleNormals);
    gl::BindTexture(GL_TEXTURE_BUFFER, look.geometry->triangle_normals());
    gl::ActiveTexture(GL_TEXTURE0 + kBaseColor);
    const ShaderProgram* current = nullptr;
    for (const SceneGeometry::Draw& draw : look.draws) {
        const bool cutout = material_of(*look.geometry, draw).is_cutout();
        const ShaderProgram& wanted = program(look, view.orthographic, cutout);
        if (current != &wanted) begin(look, wanted, view);
        current = &wanted;
        draw_mesh({*look.geometry, draw, view_from_scene}, *current);
    }
    gl::BindVertexArray(0);
}

}  // namespace aoscore
