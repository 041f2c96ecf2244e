#include "screen/gl/pass_timer.h"

#include "core/machine.h"
#include "screen/gl/context.h"
#include "screen/gl/gl.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

// Names as drivers state them: Mesa 22.3 here, the others from their public bug reports.
TEST(Renderer, IsOfSoftwareByItsName) {
    for (const char* name :
         {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Google SwiftShader",
          "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)"})
        EXPECT_TRUE(is_software_renderer(name)) << name;
    for (const char* name :
         {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "AMD Radeon RX 6600 (navi23, LLVM 15.0.6, DRM 3.49)",
          "Mesa Intel(R) UHD Graphics 620 (KBL GT2)"})
        EXPECT_FALSE(is_software_renderer(name)) << name;
}

TEST(PassTimer, OfEitherClockMeasuresEachPassByItself) {
    const std::unique_ptr<GlContext> context = new_gl_context();
    for (const PassTimer::Clock clock : {PassTimer::Clock::queries, PassTimer::Clock::wall}) {
        PassTimer first(clock), second(clock);
        for (PassTimer* timer : {&first, &second}) {
            timer->begin();
            timer->end();
        }
        for (const PassTimer* timer : {&first, &second}) {
            EXPECT_TRUE(std::isfinite(timer->milliseconds()));
            EXPECT_GE(timer->milliseconds(), 0);
            EXPECT_EQ(timer->processor_ms().has_value(), clock == PassTimer::Clock::wall);
        }
        gl::check("timing passes");
    }
}

}  // namespace
}  // namespace aoscore
