#include "screen/gbuffer/gbuffer.h"

#include "core/error.h"
#include "core/hash.h"
#include "core/known_names.h"
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

std::size_t values_of(const TextureFormat& format) {
    return format.transfer == GL_RGBA ? 4 : 1;
}

template <class Pixel>
Image<Pixel> read_pixels(const gl::Texture& texture, GLenum transfer, const ViewUniforms& view) {
    Image<Pixel> image(view.width, view.height);
    read_texture(texture.name(), transfer, image.pixels.data());
    return image;
}

Image<glm::vec4> with_fourth(const Image<glm::vec3>& vectors) {
    Image<glm::vec4> result(vectors.width, vectors.height);
    for (std::size_t i = 0; i < result.size(); ++i) result.pixels[i] = glm::vec4(vectors.pixels[i], 0.0F);
    return result;
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

std::string GBuffer::output_macros() const {
    std::string macros;
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        macros += fmt::format("#define {} {}\n", output_macro(outputs_[i]->id), i);
    return macros;
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
    geometry_ = &geometry;
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
            draw_picture(frame, picture, before);
            before = picture.textures.find("hardware_depth")->second.name();
        }
    }
    gl::check("drawing the G-buffer");
}

void GBuffer::take(const GBufferImages& images, const Capture& capture) {
    geometry_ = nullptr;
    capture_ = capture;
    outputs_.clear();
    pictures_.clear();
    Picture& picture = pictures_.emplace_back(Picture{ViewUniforms(capture.camera({})), {}});
    const auto keep = [&](const Channel& channel, const void* pixels) {
        picture.textures.emplace(
            channel.id, make_texture(format_of(channel), picture.view.width, picture.view.height, pixels));
    };
    for (const Channel& channel : gbuffer_channels()) {
        if (!is_drawn(channel, capture)) continue;
        if (const ImageF& number = images.number(channel.id); !number.empty())
            keep(channel, number.pixels.data());
        if (const Image<glm::vec3>& vector = images.vector(channel.id); !vector.empty())
            keep(channel, with_fourth(vector).pixels.data());
    }
    gl::check("taking a G-buffer");
}

void GBuffer::draw_picture(const CameraFrame& frame, const Picture& drawn, GLuint before) {
    clear(drawn);
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    drawing_.draw({geometry_, geometry_->draws(), &frame, output_macros(), before, {}});
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

std::size_t GBuffer::bytes() const {
    std::size_t values = 0;
    for (const Picture& drawn : pictures_) {
        for (const auto& [name, texture] : drawn.textures)
            values += values_of(format_of(*find_row(gbuffer_channels(), name)));
    }
    return values * sizeof(float) * static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
}

std::string GBuffer::digest() const {
    Digest digest;
    for (const Picture& drawn : pictures_) {
        for (const auto& [name, texture] : drawn.textures) {
            const TextureFormat format = format_of(*find_row(gbuffer_channels(), name));
            std::vector<float> all(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) *
                                   values_of(format));
            read_texture(texture.name(), format.transfer, all.data());
            digest.text(name).array(std::span<const float>(all));
        }
    }
    return digest.hex();
}

}  // namespace aoscore
