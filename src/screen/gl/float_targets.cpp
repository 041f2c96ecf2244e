#include "screen/gl/float_targets.h"

#include "core/error.h"
#include "screen/gl/gl.h"
#include "screen/gl/gl_objects.h"
#include "screen/gl/texture.h"

#include <fmt/format.h>

#include <array>

namespace aoscore {
namespace {

/// It needs all bits of a float's mantissa.
constexpr float kWritten = 0x1.fffffep-1f;

Error unfit(const char* what, const char* format) {
    const auto* renderer = reinterpret_cast<const char*>(gl::GetString(GL_RENDERER));
    return internal_error(
        fmt::format("the driver {} {} textures of the format {}, which every pass needs (--gl chooses another "
                    "driver)",
                    renderer == nullptr ? "in use" : renderer, what, format),
        "OpenGL");
}

void require_target(TextureFormat format, GLenum attachment, GLenum buffer, const char* name) {
    const gl::Texture texture = make_texture(format, 1, 1);
    const gl::Framebuffer framebuffer = gl::Framebuffer::create();
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl::FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
    const GLenum drawn = attachment == GL_DEPTH_ATTACHMENT ? GL_NONE : attachment;
    gl::DrawBuffers(1, &drawn);
    const bool complete = gl::CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    std::array<float, 4> read{};
    if (complete) {
        const std::array<float, 4> written{kWritten, kWritten, kWritten, kWritten};
        gl::ClearBufferfv(buffer, 0, written.data());
        read_texture(texture.name(), format.transfer, read.data());
    }
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) throw unfit("cannot draw into", name);
    if (read[0] != kWritten) throw unfit("keeps fewer than 32 bits of the floats in", name);
}

}  // namespace

void require_float_targets() {
    require_target(kR32F, GL_COLOR_ATTACHMENT0, GL_COLOR, "R32F");
    require_target(kRg32F, GL_COLOR_ATTACHMENT0, GL_COLOR, "RG32F");
    require_target(kRgba32F, GL_COLOR_ATTACHMENT0, GL_COLOR, "RGBA32F");
    require_target(kDepth32F, GL_DEPTH_ATTACHMENT, GL_DEPTH, "DEPTH_COMPONENT32F");
}

}  // namespace aoscore
