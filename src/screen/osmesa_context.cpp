#include "screen/osmesa_context.h"

#include "core/error.h"
#include "core/threads.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace aoscore {
namespace {

// Everything is drawn into framebuffer objects; OSMesa only insists that some window buffer exists.
constexpr int kWindowSize = 16;

// llvmpipe reads its number of threads once, when the first context is made.
void limit_rasteriser_threads() {
    setenv("LP_NUM_THREADS", std::to_string(thread_count()).c_str(), 0);
}

}  // namespace

struct GlContext::State {
    OSMesaContext context = nullptr;
    std::array<std::uint8_t, kWindowSize * kWindowSize * 4> window{};

    ~State() {
        if (context == nullptr) return;
        if (OSMesaGetCurrentContext() == context) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        OSMesaDestroyContext(context);
    }
};

GlContext::GlContext() : state_(std::make_unique<State>()) {
    limit_rasteriser_threads();
    const std::array<int, 13> attributes = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            0,
                                            0,
                                            0};
    state_->context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (state_->context == nullptr)
        throw internal_error("OSMesa gives no OpenGL 3.3 core context, perhaps for want of memory", "OpenGL");
    make_current();
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
    if (OSMesaGetCurrentContext() == state_->context) return;
    if (OSMesaMakeCurrent(state_->context, state_->window.data(), GL_UNSIGNED_BYTE, kWindowSize,
                          kWindowSize) == GL_FALSE) {
        throw internal_error("the OpenGL context cannot be made current", "OpenGL");
    }
}

GlContext::Function GlContext::function(const char* name) {
    return OSMesaGetProcAddress(name);
}

}  // namespace aoscore
