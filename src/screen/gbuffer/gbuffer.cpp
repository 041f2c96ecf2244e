#include "screen/gbuffer/gbuffer.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "scene/cofactors.h"
#include "screen/gl/texture.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace aoscore {
namespace {

struct InputFormat {
    const char* name;
    TextureFormat format;
    glm::vec4 clear;
};
// Colour inputs in the order of their attachments. A normal of the background faces the camera, so that a
// method which reads one stays finite.
const std::array<InputFormat, 4> kColourInputs = {{
    {"linear_depth", kR32F, glm::vec4(0)},
    {"normal_geometric", kRgba32F, glm::vec4(0, 0, 1, 0)},
    {"normal_smooth", kRgba32F, glm::vec4(0, 0, 1, 0)},
    {"albedo", kRgba32F, glm::vec4(0, 0, 0, 0)},
}};

const InputFormat& colour_input(const std::string& name) {
    for (const InputFormat& input : kColourInputs) {
        if (name == input.name) return input;
    }
    throw internal_error("no such G-buffer input: " + name, "screen/gbuffer.cpp");
}

// Normals transform by the cofactor matrix, which exists for flattened instances too. Its sign does not
// matter: normals are turned to the camera. Scaled to keep float in range.
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

Image<glm::vec3> read_normals(const gl::Texture& texture, int width, int height) {
    Image<glm::vec3> image(width, height);
    read_texture(texture.name(), GL_RGB, image.pixels.data());
    return image;
}

}  // namespace

const std::set<std::string>& gbuffer_inputs() {
    static const std::set<std::string> all = {"linear_depth", "hardware_depth", "normal_geometric",
                                              "normal_smooth", "albedo"};
    return all;
}

void GBuffer::allocate(const std::set<std::string>& inputs) {
    textures_.clear();
    outputs_.clear();
    framebuffer_ = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    for (const InputFormat& input : kColourInputs) {
        if (std::string(input.name) != "linear_depth" && !inputs.contains(input.name)) continue;
        gl::Texture texture = make_texture(input.format, view_.width, view_.height);
        gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs_.size()),
                                 GL_TEXTURE_2D, texture.name(), 0);
        outputs_.emplace_back(input.name);
        textures_.emplace(input.name, std::move(texture));
    }
    gl::Texture depth = make_texture(kDepth32F, view_.width, view_.height);
    gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.name(), 0);
    textures_.emplace("hardware_depth", std::move(depth));
    std::vector<GLenum> buffers;
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    gl::DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw internal_error("the G-buffer's framebuffer is incomplete", "OpenGL");
    }
}

const ShaderProgram& GBuffer::program(bool cutout) {
    std::string macros = fmt::format("#define ORTHOGRAPHIC {}\n", view_.orthographic ? 1 : 0);
    if (cutout) macros += "#define CUTOUT\n";
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        std::string name = "OUTPUT_";
        for (const char c : outputs_[i])
            name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        macros += fmt::format("#define {} {}\n", name, i);
    }
    const auto found = programs_.find(macros);
    if (found != programs_.end()) return found->second;
    const auto folder = home_dir() / "shaders" / "gbuffer";
    ShaderSource vertex, fragment;
    vertex.add_block("(G-buffer's macros)", macros);
    vertex.add_file(folder / "scene.vert", folder);
    fragment.add_block("(G-buffer's macros)", macros);
    fragment.add_file(folder / "scene.frag", folder);
    return programs_.emplace(macros, ShaderProgram("G-buffer", vertex, fragment)).first->second;
}

void GBuffer::set_view_uniforms(const ShaderProgram& p) const {
    gl::Uniform2f(p.location("u_size_px"), static_cast<float>(view_.width), static_cast<float>(view_.height));
    gl::Uniform2f(p.location("u_pixel_size"), static_cast<float>(view_.pixel_size.x),
                  static_cast<float>(view_.pixel_size.y));
    gl::Uniform1f(p.location("u_near"), static_cast<float>(view_.near));
    gl::Uniform1f(p.location("u_far"), static_cast<float>(view_.far));
}

void GBuffer::draw_mesh(const SceneGeometry& geometry, const SceneGeometry::Draw& draw,
                        const ShaderProgram& p) const {
    const SceneGeometry::Range& range = geometry.ranges()[static_cast<std::size_t>(draw.range)];
    const Material& material = geometry.materials()[static_cast<std::size_t>(range.material)];
    const glm::dmat4 view_from_mesh = view_from_scene_ * draw.scene_from_mesh;
    gl::UniformMatrix4fv(p.location("u_view_from_mesh"), 1, GL_FALSE,
                         glm::value_ptr(glm::mat4(view_from_mesh)));
    gl::UniformMatrix3fv(p.location("u_normal_from_mesh"), 1, GL_FALSE,
                         glm::value_ptr(normal_matrix(view_from_mesh)));
    gl::Uniform1i(p.location("u_first_triangle"), range.first_triangle);
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

void GBuffer::draw(const SceneGeometry& geometry, const CameraFrame& frame,
                   const std::set<std::string>& inputs) {
    for (const std::string& input : inputs) {
        if (!gbuffer_inputs().contains(input))
            throw internal_error("no such G-buffer input: " + input, "draw_gbuffer");
    }
    frame_ = frame;
    view_ = ViewUniforms(frame);
    view_from_scene_ = frame.view_from_world();
    clip_from_view_ = frame.clip_from_view();
    clip_from_view_[1] *= -1.0;  // row 0 at the top
    allocate(inputs);

    gl::Viewport(0, 0, view_.width, view_.height);
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const glm::vec4 clear = outputs_[i] == "linear_depth" ? glm::vec4(static_cast<float>(view_.far))
                                                              : colour_input(outputs_[i]).clear;
        gl::ClearBufferfv(GL_COLOR, static_cast<GLint>(i), glm::value_ptr(clear));
    }
    const float farthest = 1.0F;
    gl::ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    gl::BindVertexArray(geometry.vertex_array());
    gl::ActiveTexture(GL_TEXTURE1);
    gl::BindTexture(GL_TEXTURE_BUFFER, geometry.triangle_normals());
    gl::ActiveTexture(GL_TEXTURE0);

    const ShaderProgram* current = nullptr;
    for (const SceneGeometry::Draw& draw : geometry.draws()) {
        const auto& range = geometry.ranges()[static_cast<std::size_t>(draw.range)];
        const bool cutout = geometry.materials()[static_cast<std::size_t>(range.material)].is_cutout();
        const ShaderProgram& wanted = program(cutout);
        if (current != &wanted) {
            current = &wanted;
            current->use();
            set_view_uniforms(*current);
            gl::UniformMatrix4fv(current->location("u_clip_from_view"), 1, GL_FALSE,
                                 glm::value_ptr(glm::mat4(clip_from_view_)));
            gl::Uniform1i(current->location("u_base_color_texture"), 0);
            gl::Uniform1i(current->location("u_triangle_normals"), 1);
        }
        draw_mesh(geometry, draw, *current);
    }
    gl::BindVertexArray(0);
    gl::Disable(GL_DEPTH_TEST);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check("drawing the G-buffer");
}

GLuint GBuffer::texture(const std::string& input) const {
    const auto found = textures_.find(input);
    return found == textures_.end() ? 0 : found->second.name();
}

GBufferImages GBuffer::read() const {
    GBufferImages images;
    images.linear_depth = ImageF(view_.width, view_.height);
    read_texture(texture("linear_depth"), GL_RED, images.linear_depth.pixels.data());
    images.hardware_depth = ImageF(view_.width, view_.height);
    read_texture(texture("hardware_depth"), GL_DEPTH_COMPONENT, images.hardware_depth.pixels.data());
    images.surface = Mask(view_.width, view_.height);
    for (std::size_t i = 0; i < images.surface.size(); ++i) {
        images.surface.pixels[i] = images.linear_depth.pixels[i] < static_cast<float>(view_.far) ? 1 : 0;
    }
    for (const auto& [name, target] :
         {std::pair("normal_geometric", &images.normal_geometric),
          std::pair("normal_smooth", &images.normal_smooth), std::pair("albedo", &images.albedo)}) {
        const auto found = textures_.find(name);
        if (found != textures_.end()) *target = read_normals(found->second, view_.width, view_.height);
    }
    return images;
}

std::string GBuffer::digest() const {
    Digest digest;
    for (const auto& [name, texture] : textures_) {
        const bool depth = name == "hardware_depth";
        const bool single = depth || name == "linear_depth";
        std::vector<float> values(static_cast<std::size_t>(view_.width) *
                                  static_cast<std::size_t>(view_.height) * (single ? 1 : 4));
        read_texture(texture.name(), depth ? GL_DEPTH_COMPONENT : single ? GL_RED : GL_RGBA, values.data());
        digest.text(name).array(std::span<const float>(values));
    }
    return digest.hex();
}

}  // namespace aoscore
