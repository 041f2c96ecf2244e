#pragma once

#include <memory>
#include <string>

namespace aoscore {

/// An off-screen OpenGL 3.3 core context. Everything is drawn into framebuffer objects.
///
/// Implementations:
///   OsmesaContext (osmesa_context.h)  OSMesa: software rendering by llvmpipe, without a display or a GPU
///   EglContext (egl_context.h)        EGL: a GPU's driver, without a display
class GlContext {
  public:
    GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    virtual ~GlContext() = default;

    /// Makes this the calling thread's context. Throws internal_error where the library refuses.
    virtual void make_current() = 0;

    using Function = void (*)();
    /// The entry point of an OpenGL function ("glClear"); null when there is none.
    virtual Function function(const char* name) const = 0;

    /// Whether the driver says when it has lost the context (ARB_robustness).
    virtual bool tells_loss() const { return false; }
};

/// Chooses where contexts come from: "osmesa", "egl", or "egl:DEVICE", an index or a part of a device's name.
/// It is the environment variable AOSCORE_GL of this process, which its child processes take over. Throws
/// usage_error for anything else.
void choose_gl(const std::string& choice);

/// The choice: AOSCORE_GL where it is set, else "osmesa". Throws usage_error where it is not one.
std::string chosen_gl();

/// The one place that chooses an implementation. Makes the context current and loads the functions of gl.h.
/// Throws internal_error when no context can be made, a function is missing, or the driver cannot draw into
/// textures of 32-bit floats (float_targets.h).
std::unique_ptr<GlContext> new_gl_context();

}  // namespace aoscore
