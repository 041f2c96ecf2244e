#include "screen/gl/gl.h"

#include "core/error.h"
#include "screen/gl/context.h"

#include <fmt/format.h>

namespace aoscore::gl {

#define AOSCORE_GL_DEFINE(UPPER, Name) PFNGL##UPPER##PROC Name = nullptr;
AOSCORE_GL_FUNCTIONS(AOSCORE_GL_DEFINE)
#undef AOSCORE_GL_DEFINE

void load_functions(const GlContext& context) {
#define AOSCORE_GL_LOAD(UPPER, Name)                                           \
    Name = reinterpret_cast<PFNGL##UPPER##PROC>(context.function("gl" #Name)); \
    if (Name == nullptr) throw internal_error("the function gl" #Name " is missing", "OpenGL");
    AOSCORE_GL_FUNCTIONS(AOSCORE_GL_LOAD)
#undef AOSCORE_GL_LOAD
}

void check(const char* doing) {
    const GLenum error = GetError();
    if (error == GL_NO_ERROR) return;
    while (GetError() != GL_NO_ERROR) {
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
