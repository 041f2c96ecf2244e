#include "screen/gl/texture.h"

#include "core/error.h"

#include <algorithm>

namespace aoscore {

namespace {

gl::Texture bound_texture(int levels, GLenum target = GL_TEXTURE_2D) {
    gl::Texture texture = gl::Texture::create();
    gl::BindTexture(target, texture.name());
    gl::TexParameteri(target, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    gl::TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl::TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl::TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl::TexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    return texture;
}

void read_bound(GLenum target, GLenum transfer, void* pixels) {
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::GetTexImage(target, 0, transfer, GL_FLOAT, pixels);
    gl::check("reading a texture");
}

/// Selects the colour buffers of the bound framebuffer for drawing.
void draw_into(int count) {
    std::vector<GLenum> buffers;
    for (int i = 0; i < count; ++i) buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    gl::DrawBuffers(count, buffers.data());
    if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw internal_error("a pass's framebuffer is incomplete", "OpenGL");
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

gl::Texture make_texture_array(TextureFormat format, int width, int height, int count) {
    gl::Texture array = bound_texture(1, GL_TEXTURE_2D_ARRAY);
    gl::TexImage3D(GL_TEXTURE_2D_ARRAY, 0, format.internal, width, height, count, 0, format.transfer,
                   GL_FLOAT, nullptr);
    gl::check("making an array of textures");
    return array;
}

void read_texture(GLuint texture, GLenum transfer, void* pixels) {
    gl::BindTexture(GL_TEXTURE_2D, texture);
    read_bound(GL_TEXTURE_2D, transfer, pixels);
}

void read_texture_array(GLuint array, GLenum transfer, void* pixels) {
    gl::BindTexture(GL_TEXTURE_2D_ARRAY, array);
    read_bound(GL_TEXTURE_2D_ARRAY, transfer, pixels);
}

gl::Framebuffer make_framebuffer(const std::vector<GLuint>& textures, int level) {
    gl::Framebuffer framebuffer = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    GLenum place = GL_COLOR_ATTACHMENT0;
    for (const GLuint texture : textures)
        gl::FramebufferTexture2D(GL_FRAMEBUFFER, place++, GL_TEXTURE_2D, texture, level);
    draw_into(static_cast<int>(textures.size()));
    return framebuffer;
}

gl::Framebuffer make_array_framebuffer(GLuint array, int first, int count, GLuint depth) {
    gl::Framebuffer framebuffer = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    for (int i = 0; i < count; ++i) {
        gl::FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), array, 0,
                                    first + i);
    }
    if (depth != 0) gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    draw_into(count);
    return framebuffer;
}

}  // namespace aoscore
