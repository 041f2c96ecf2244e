#include "screen/gl/osmesa_context.h"

#include "core/error.h"
#include "core/threads.h"

#include <GL/osmesa.h>
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace aoscore {
namespace {

// Everything is drawn into framebuffer objects; OSMesa only requires that some window buffer exists.
constexpr int kWindowSize = 16;

// Sets the number of threads of llvmpipe, which reads it once, when the first context is made.
void limit_rasteriser_threads() {
    setenv("LP_NUM_THREADS", std::to_string(thread_count()).c_str(), 0);
}

// Checks that enough addresses are left: Mesa does not check whether it got the memory that it asked for, and
// crashes where it did not. It has the rasteriser's threads and a few of its own, each with a stack and a
// heap of the C library. The numbers are those of Mesa 22.3, with room for the first shaders.
void require_addresses() {
    constexpr std::size_t kMiB = std::size_t{1} << 20, kThread = 72 * kMiB, kRest = 256 * kMiB;
    constexpr int kMostRasterisers = 32, kOwnThreads = 4;
    const int threads = std::min(thread_count(), kMostRasterisers) + kOwnThreads;
    const std::size_t needed = kRest + static_cast<std::size_t>(threads) * kThread;
    void* room = mmap(nullptr, needed, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        throw internal_error(
            fmt::format("not enough memory: {} MiB of addresses are needed for it, more than "
                        "the limit (ulimit -v) leaves; fewer --threads need less",
                        needed / kMiB),
            "OpenGL");
    munmap(room, needed);
}

}  // namespace

struct OsmesaContext::State {
    OSMesaContext context = nullptr;
    std::array<std::uint8_t, kWindowSize * kWindowSize * 4> window{};

    ~State() {
        if (context == nullptr) return;
        if (OSMesaGetCurrentContext() == context) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        OSMesaDestroyContext(context);
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
    state_->context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (state_->context == nullptr)
        throw internal_error("OSMesa gives no OpenGL 3.3 core context, perhaps for want of memory", "OpenGL");
    make_current();
}

OsmesaContext::~OsmesaContext() = default;

void OsmesaContext::make_current() {
    if (OSMesaGetCurrentContext() == state_->context) return;
    if (OSMesaMakeCurrent(state_->context, state_->window.data(), GL_UNSIGNED_BYTE, kWindowSize,
                          kWindowSize) == GL_FALSE) {
        throw internal_error("the OpenGL context cannot be made current", "OpenGL");
    }
}

GlContext::Function OsmesaContext::function(const char* name) const {
    return OSMesaGetProcAddress(name);
}

}  // namespace aoscore
