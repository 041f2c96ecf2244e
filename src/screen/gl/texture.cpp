#include "screen/gl/texture.h"

#include "core/error.h"

#include <algorithm>

namespace aoscore {

namespace {

gl::Texture bound_texture(int levels) {
    gl::Texture texture = gl::Texture::create();
    gl::BindTexture(GL_TEXTURE_2D, texture.name());
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                      levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    return texture;
}

}  // namespace

gl::Texture make_texture(TextureFormat format, int width, int height, const void* pixels) {
    gl::Texture texture = bound_texture(1);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl::TexImage2D(GL_TEXTURE_2D, 0, format.internal, width, height, 0, format.transfer, GL_FLOAT, pixels);
    gl::check("making a texture");
    return texture;
}

gl::Texture make_mipmapped_texture(TextureFormat format, int width, int height, int levels) {
    gl::Texture texture = bound_texture(levels);
    for (int level = 0; level < levels; ++level) {
        gl::TexImage2D(GL_TEXTURE_2D, level, format.internal, std::max(width >> level, 1),
                       std::max(height >> level, 1), 0, format.transfer, GL_FLOAT, nullptr);
    }
    gl::check("making a texture with mips");
    return texture;
}

void read_texture(GLuint texture, GLenum transfer, void* pixels) {
    gl::BindTexture(GL_TEXTURE_2D, texture);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::GetTexImage(GL_TEXTURE_2D, 0, transfer, GL_FLOAT, pixels);
    gl::check("reading a texture");
}

gl::Framebuffer make_framebuffer(const std::vector<GLuint>& textures, int level) {
    gl::Framebuffer framebuffer = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    std::vector<GLenum> buffers;
    for (const GLuint texture : textures) {
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        gl::FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, texture, level);
    }
    gl::DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw internal_error("a pass's framebuffer is incomplete", "OpenGL");
    }
    return framebuffer;
}

}  // namespace aoscore
