#include "screen/gl/gl.h"

#include "core/error.h"
#include "screen/gl/context.h"

#include <fmt/format.h>

namespace aoscore::gl {

#define AOSCORE_GL_DEFINE(UPPER, Name) PFNGL##UPPER##PROC Name = nullptr;
AOSCORE_GL_FUNCTIONS(AOSCORE_GL_DEFINE)
#undef AOSCORE_GL_DEFINE

namespace {

bool lost = false;
/// Of ARB_robustness; null where the context does not tell.
PFNGLGETGRAPHICSRESETSTATUSPROC reset_status = nullptr;

/// A lost context can state the same error for ever.
constexpr int kMostErrors = 64;

}  // namespace

void load_functions(const GlContext& context) {
#define AOSCORE_GL_LOAD(UPPER, Name)                                           \
    Name = reinterpret_cast<PFNGL##UPPER##PROC>(context.function("gl" #Name)); \
    if (Name == nullptr) throw internal_error("the function gl" #Name " is missing", "OpenGL");
    AOSCORE_GL_FUNCTIONS(AOSCORE_GL_LOAD)
#undef AOSCORE_GL_LOAD
    lost = false;
    reset_status = context.tells_loss() ? reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSPROC>(
                                              context.function("glGetGraphicsResetStatusARB"))
                                        : nullptr;
}

bool context_lost() {
    return lost;
}

void check(const char* doing) {
    const GLenum error = GetError();
    if (error == GL_CONTEXT_LOST || (reset_status != nullptr && reset_status() != GL_NO_ERROR)) {
        lost = true;
        throw internal_error("the driver has lost its context: a pass took longer than it allows, or failed",
                             fmt::format("OpenGL, {}", doing));
    }
    if (error == GL_NO_ERROR) return;
    for (int i = 0; i < kMostErrors && GetError() != GL_NO_ERROR; ++i) {
    }
    const char* name = error == GL_INVALID_ENUM                    ? "invalid enum"
                       : error == GL_INVALID_VALUE                 ? "invalid value"
                       : error == GL_INVALID_OPERATION             ? "invalid operation"
                       : error == GL_INVALID_FRAMEBUFFER_OPERATION ? "incomplete framebuffer"
                       : error == GL_OUT_OF_MEMORY                 ? "out of memory"
                                                                   : "unknown error";
    throw internal_error(fmt::format("{} (0x{:04x})", name, error), fmt::format("OpenGL, {}", doing));
}

}  // namespace aoscore::gl
