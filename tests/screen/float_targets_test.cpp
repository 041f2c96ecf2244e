// Drivers that nobody here has: their answers are put in place of this one's.
#include "core/error.h"
#include "screen/gl/context.h"
#include "screen/gl/float_targets.h"
#include "screen/gl/gl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace aoscore::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

PFNGLTEXIMAGE2DPROC g_tex_image = nullptr;
std::map<GLint, GLint> g_stored_as;

/// The message of the refusal; empty where there was none.
std::string refusal() {
    try {
        require_float_targets();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::internal);
        return e.what();
    }
    return {};
}

class FloatTargets : public ::testing::Test {
  protected:
    FloatTargets() : context_(new_gl_context()), status_(gl::CheckFramebufferStatus) {
        g_tex_image = gl::TexImage2D;
    }
    ~FloatTargets() override {
        gl::CheckFramebufferStatus = status_;
        gl::TexImage2D = g_tex_image;
    }

  private:
    std::unique_ptr<GlContext> context_;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC status_;
};

TEST_F(FloatTargets, AreThereOnTheDriverThatTheTestsDrawWith) {
    EXPECT_EQ(refusal(), "");
}

TEST_F(FloatTargets, ThatCannotBeDrawnIntoAreRefusedByName) {
    gl::CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_UNSUPPORTED; };
    EXPECT_THAT(refusal(), AllOf(HasSubstr("cannot draw into"), HasSubstr("R32F"), HasSubstr("--gl")));
}

TEST_F(FloatTargets, ThatKeepFewerBitsAreRefusedByName) {
    const std::map<std::string, std::pair<GLint, GLint>> formats = {
        {" R32F", {GL_R32F, GL_R16F}},
        {" RG32F", {GL_RG32F, GL_RG16F}},
        {" RGBA32F", {GL_RGBA32F, GL_RGBA16F}},
        {" DEPTH_COMPONENT32F", {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT16}}};
    gl::TexImage2D = [](GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLint border,
                        GLenum transfer, GLenum type, const void* pixels) {
        const auto stored = g_stored_as.find(format);
        g_tex_image(target, level, stored == g_stored_as.end() ? format : stored->second, width, height, border,
                    transfer, type, pixels);
    };
    for (const auto& [name, format] : formats) {
        g_stored_as = {format};
        EXPECT_THAT(refusal(), AllOf(HasSubstr("fewer than 32 bits"), HasSubstr(name + ","))) << name;
    }
}

}  // namespace
}  // namespace aoscore::testing
