#include "screen/gbuffer/gbuffer.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "core/known_names.h"
#include "scene/cofactors.h"
#include "screen/gbuffer/channel_glsl.h"
#include "screen/gl/texture.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <span>

namespace aoscore {
namespace {

bool is_depth_buffer(const Channel& channel) {
    return channel.glsl_value.empty();
}

bool is_drawn(const Channel& channel, const Capture& capture) {
    return channel.always_drawn || capture.channels.contains(std::string(channel.id));
}

TextureFormat format_of(const Channel& channel) {
    if (is_depth_buffer(channel)) return kDepth32F;
    return channel.form == ChannelForm::number ? kR32F : kRgba32F;
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

template <class Pixel>
Image<Pixel> read_pixels(const gl::Texture& texture, GLenum transfer, const ViewUniforms& view) {
    Image<Pixel> image(view.width, view.height);
    read_texture(texture.name(), transfer, image.pixels.data());
    return image;
}

struct MeshPlace {
    const SceneGeometry& geometry;
    const SceneGeometry::Draw& draw;
    const glm::dmat4& view_from_scene;
};

void draw_mesh(const MeshPlace& place, const ShaderProgram& p) {
    const SceneGeometry& geometry = place.geometry;
    const SceneGeometry::Range& range = geometry.ranges()[static_cast<std::size_t>(place.draw.range)];
    const Material& material = geometry.materials()[static_cast<std::size_t>(range.material)];
    const glm::dmat4 view_from_mesh = place.view_from_scene * place.draw.scene_from_mesh;
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

}  // namespace

const ImageF& GBufferImages::number(std::string_view channel) const {
    static const ImageF none;
    const auto found = numbers.find(channel);
    return found == numbers.end() ? none : found->second;
}

const Image<glm::vec3>& GBufferImages::vector(std::string_view channel) const {
    static const Image<glm::vec3> none;
    const auto found = vectors.find(channel);
    return found == vectors.end() ? none : found->second;
}

const std::set<std::string>& gbuffer_inputs() {
    static const std::set<std::string> all = [] {
        std::set<std::string> ids;
        for (const Channel& channel : gbuffer_channels()) ids.emplace(channel.id);
        return ids;
    }();
    return all;
}

void GBuffer::allocate(Picture& made) {
    framebuffer_ = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    std::vector<GLenum> buffers;
    for (const Channel& channel : gbuffer_channels()) {
        if (!is_drawn(channel, *capture_)) continue;
        gl::Texture texture = make_texture(format_of(channel), made.view.width, made.view.height);
        GLenum place = GL_DEPTH_ATTACHMENT;
        if (!is_depth_buffer(channel)) {
            place = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
            buffers.push_back(place);
        }
        gl::FramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.name(), 0);
        made.textures.emplace(channel.id, std::move(texture));
    }
    gl::DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw internal_error("the G-buffer's framebuffer is incomplete", "OpenGL");
    }
}

const ShaderProgram& GBuffer::program(bool orthographic, bool cutout, bool peeled) {
    std::string macros = fmt::format("#define ORTHOGRAPHIC {}\n", orthographic ? 1 : 0);
    if (cutout) macros += "#define CUTOUT\n";
    if (peeled) macros += "#define PEELED\n";
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        macros += fmt::format("#define {} {}\n", output_macro(outputs_[i]->id), i);
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

void GBuffer::set_view_uniforms(const ShaderProgram& p, const CaptureIndex& index) const {
    picture(index).view.set(p);
}

void GBuffer::clear(const Picture& cleared) const {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const Channel& channel = *outputs_[i];
        const glm::vec4 value = channel.background_is_far ? glm::vec4(static_cast<float>(cleared.view.far))
                                                          : glm::make_vec4(channel.background.data());
        gl::ClearBufferfv(GL_COLOR, static_cast<GLint>(i), glm::value_ptr(value));
    }
    const float farthest = 1.0F;
    gl::ClearBufferfv(GL_DEPTH, 0, &farthest);
}

void GBuffer::draw(const SceneGeometry& geometry, const Capture& capture) {
    for (const std::string& channel : capture.channels) {
        if (find_row(gbuffer_channels(), channel) == nullptr)
            throw internal_error("no such channel of the G-buffer: " + channel, "draw_gbuffer");
    }
    capture_ = capture;
    pictures_.clear();
    outputs_.clear();
    for (const Channel& channel : gbuffer_channels()) {
        if (is_drawn(channel, capture) && !is_depth_buffer(channel)) outputs_.push_back(&channel);
    }
    for (const CameraFrame& frame : capture.cameras) {
        GLuint before = 0;
        for (int layer = 0; layer < capture.layers; ++layer) {
            Picture& picture = pictures_.emplace_back(Picture{ViewUniforms(frame), {}});
            if (picture.view.width != width() || picture.view.height != height())
                throw internal_error("the cameras of a capture are of several sizes", "draw_gbuffer");
            allocate(picture);
            draw_picture(geometry, frame, picture, before);
            before = picture.textures.find("hardware_depth")->second.name();
        }
    }
    gl::check("drawing the G-buffer");
}

void GBuffer::draw_picture(const SceneGeometry& geometry, const CameraFrame& frame, const Picture& drawn,
                           GLuint before) {
    const glm::dmat4 view_from_scene = frame.view_from_world();
    glm::dmat4 clip_from_view = frame.clip_from_view();
    clip_from_view[1] *= -1.0;  // row 0 at the top
    gl::Viewport(0, 0, drawn.view.width, drawn.view.height);
    clear(drawn);
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    gl::BindVertexArray(geometry.vertex_array());
    gl::ActiveTexture(GL_TEXTURE2);
    gl::BindTexture(GL_TEXTURE_2D, before);
    gl::ActiveTexture(GL_TEXTURE1);
    gl::BindTexture(GL_TEXTURE_BUFFER, geometry.triangle_normals());
    gl::ActiveTexture(GL_TEXTURE0);

    const ShaderProgram* current = nullptr;
    for (const SceneGeometry::Draw& draw : geometry.draws()) {
        const auto& range = geometry.ranges()[static_cast<std::size_t>(draw.range)];
        const bool cutout = geometry.materials()[static_cast<std::size_t>(range.material)].is_cutout();
        const ShaderProgram& wanted = program(drawn.view.orthographic, cutout, before != 0);
        if (current != &wanted) {
            current = &wanted;
            current->use();
            drawn.view.set(*current);
            gl::UniformMatrix4fv(current->location("u_clip_from_view"), 1, GL_FALSE,
                                 glm::value_ptr(glm::mat4(clip_from_view)));
            gl::Uniform1i(current->location("u_base_color_texture"), 0);
            gl::Uniform1i(current->location("u_triangle_normals"), 1);
            gl::Uniform1i(current->location("u_layer_before"), 2);
        }
        draw_mesh({geometry, draw, view_from_scene}, *current);
    }
    gl::BindVertexArray(0);
    gl::Disable(GL_DEPTH_TEST);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
}

GLuint GBuffer::texture(std::string_view channel, const CaptureIndex& index) const {
    const Picture& asked = picture(index);
    const auto found = asked.textures.find(channel);
    return found == asked.textures.end() ? 0 : found->second.name();
}

GBufferImages GBuffer::read(const CaptureIndex& index) const {
    const Picture& asked = picture(index);
    GBufferImages images;
    for (const Channel& channel : gbuffer_channels()) {
        const auto found = asked.textures.find(channel.id);
        if (found == asked.textures.end()) continue;
        const std::string id(channel.id);
        if (channel.form == ChannelForm::number)
            images.numbers[id] = read_pixels<float>(found->second, format_of(channel).transfer, asked.view);
        else
            images.vectors[id] = read_pixels<glm::vec3>(found->second, GL_RGB, asked.view);
    }
    const ImageF& depth = images.linear_depth();
    images.surface = Mask(depth.width, depth.height);
    for (std::size_t i = 0; i < images.surface.size(); ++i)
        images.surface.pixels[i] = depth.pixels[i] < far_depth(index) ? 1 : 0;
    return images;
}

std::string GBuffer::digest() const {
    Digest digest;
    for (const Picture& drawn : pictures_) {
        for (const auto& [name, texture] : drawn.textures) {
            const TextureFormat format = format_of(*find_row(gbuffer_channels(), name));
            const std::size_t values = format.transfer == GL_RGBA ? 4 : 1;
            std::vector<float> all(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) *
                                   values);
            read_texture(texture.name(), format.transfer, all.data());
            digest.text(name).array(std::span<const float>(all));
        }
    }
    return digest.hex();
}

}  // namespace aoscore
