#pragma once

#include <memory>

namespace aoscore {

/// The off-screen OpenGL 3.3 core context. The only part of the program that knows which library provides it
/// (OSMesa, software rendering by llvmpipe); EGL's surfaceless platform would replace this file alone.
class GlContext {
  public:
    /// Creates the context and makes it current. Throws internal_error when the library gives none.
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Makes this the calling thread's context.
    void make_current();

    using Function = void (*)();
    /// The entry point of an OpenGL function ("glClear"), null when there is none.
    static Function function(const char* name);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aoscore
