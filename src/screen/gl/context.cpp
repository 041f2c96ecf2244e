#include "screen/gl/context.h"

#include "core/error.h"
#include "screen/gl/egl_context.h"
#include "screen/gl/float_targets.h"
#include "screen/gl/gl.h"
#include "screen/gl/osmesa_context.h"

#include <cstdlib>

namespace aoscore {
namespace {

constexpr const char* kVariable = "AOSCORE_GL";
constexpr std::string_view kOsmesa = "osmesa", kEgl = "egl", kEglDevice = "egl:";

void require_choice(const std::string& choice) {
    if (choice == kOsmesa || choice == kEgl || (choice.starts_with(kEglDevice) && choice != kEglDevice))
        return;
    throw usage_error("no OpenGL is called " + choice +
                      " (valid: osmesa, egl, or egl:DEVICE, see list devices)");
}

std::unique_ptr<GlContext> context_of(const std::string& choice) {
    if (choice == kOsmesa) return std::make_unique<OsmesaContext>();
    return std::make_unique<EglContext>(choice == kEgl ? "" : choice.substr(kEglDevice.size()));
}

}  // namespace

void choose_gl(const std::string& choice) {
    require_choice(choice);
    setenv(kVariable, choice.c_str(), 1);
}

std::string chosen_gl() {
    const char* value = std::getenv(kVariable);
    const std::string choice = value == nullptr || *value == '\0' ? std::string(kOsmesa) : value;
    require_choice(choice);
    return choice;
}

std::unique_ptr<GlContext> new_gl_context() {
    std::unique_ptr<GlContext> context = context_of(chosen_gl());
    gl::load_functions(*context);
    require_float_targets();
    return context;
}

}  // namespace aoscore
