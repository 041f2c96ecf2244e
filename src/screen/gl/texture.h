#pragma once

#include "core/image.h"
#include "screen/gl/gl_objects.h"

#include <vector>

namespace aoscore {

/// An internal format with the transfer format that fits it.
struct TextureFormat {
    GLint internal;
    GLenum transfer;
};
inline constexpr TextureFormat kR32F{GL_R32F, GL_RED};
inline constexpr TextureFormat kRg32F{GL_RG32F, GL_RG};
inline constexpr TextureFormat kRgba32F{GL_RGBA32F, GL_RGBA};
inline constexpr TextureFormat kDepth32F{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT};

/// Makes a 2-D texture without mips, unfiltered and clamped, from `pixels` (floats, row 0 first) where given.
gl::Texture make_texture(TextureFormat format, int width, int height, const void* pixels = nullptr);

/// Makes an unfilled texture with `levels` levels, each half of the one before (rounded down, at least 1).
gl::Texture make_mipmapped_texture(TextureFormat format, int width, int height, int levels);

/// Makes an unfilled array of textures of one size: GL_TEXTURE_2D_ARRAY.
gl::Texture make_texture_array(TextureFormat format, int width, int height, int count);

/// Reads level 0 as floats, row 0 first; `pixels` must hold all of it.
void read_texture(GLuint texture, GLenum transfer, void* pixels);

/// Reads all textures of an array, one after the other.
void read_texture_array(GLuint array, GLenum transfer, void* pixels);

/// Makes a framebuffer that draws into this level of these textures, in order. It stays bound.
gl::Framebuffer make_framebuffer(const std::vector<GLuint>& textures, int level = 0);

/// Makes a framebuffer for `count` textures of an array from the `first`, with a depth buffer where one is
/// given.
gl::Framebuffer make_array_framebuffer(GLuint array, int first, int count, GLuint depth = 0);

}  // namespace aoscore
