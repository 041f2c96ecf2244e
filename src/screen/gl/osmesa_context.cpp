#include "screen/gl/osmesa_context.h"

#include "core/error.h"
#include "screen/gl/llvmpipe.h"
#include "screen/gl/loaded_library.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

namespace aoscore {
namespace {

// Everything is drawn into framebuffer objects; OSMesa only requires that some window buffer exists.
constexpr int kWindowSize = 16;

struct Osmesa {
    LoadedLibrary library{"libOSMesa.so.8", "libosmesa6"};
    decltype(&OSMesaCreateContextAttribs) create =
        library.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    decltype(&OSMesaDestroyContext) destroy =
        library.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(&OSMesaGetCurrentContext) current =
        library.function<decltype(&OSMesaGetCurrentContext)>("OSMesaGetCurrentContext");
    decltype(&OSMesaMakeCurrent) make_current =
        library.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(&OSMesaGetProcAddress) address =
        library.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

const Osmesa& osmesa() {
    static const Osmesa loaded;
    return loaded;
}

}  // namespace

struct OsmesaContext::State {
    OSMesaContext context = nullptr;
    std::array<std::uint8_t, kWindowSize * kWindowSize * 4> window{};

    ~State() {
        if (context == nullptr) return;
        if (osmesa().current() == context) osmesa().make_current(nullptr, nullptr, 0, 0, 0);
        osmesa().destroy(context);
    }
};

OsmesaContext::OsmesaContext() : state_(std::make_unique<State>()) {
    limit_rasteriser_threads();
    require_addresses();
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
    state_->context = osmesa().create(attributes.data(), nullptr);
    if (state_->context == nullptr)
        throw internal_error("OSMesa gives no OpenGL 3.3 core context, perhaps for want of memory", "OpenGL");
    make_current();
}

OsmesaContext::~OsmesaContext() = default;

void OsmesaContext::make_current() {
    if (osmesa().current() == state_->context) return;
    if (osmesa().make_current(state_->context, state_->window.data(), GL_UNSIGNED_BYTE, kWindowSize,
                              kWindowSize) == GL_FALSE) {
        throw internal_error("the OpenGL context cannot be made current", "OpenGL");
    }
}

GlContext::Function OsmesaContext::function(const char* name) const {
    return osmesa().address(name);
}

}  // namespace aoscore
