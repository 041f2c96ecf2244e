#pragma once

#include <memory>

namespace aoscore {

/// An off-screen OpenGL 3.3 core context. Everything is drawn into framebuffer objects.
///
/// Implementations:
///   OsmesaContext (osmesa_context.h)  OSMesa: software rendering by llvmpipe, without a display or a GPU
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
};

/// The one place that chooses an implementation. Makes the context current and loads the functions of gl.h.
/// Throws internal_error when no context can be made, or a function is missing.
std::unique_ptr<GlContext> new_gl_context();

}  // namespace aoscore
