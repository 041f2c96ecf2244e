// Tests that a driver that loses its context fails the cell that it was drawing, and no other. A software
// renderer loses none: its answer to glGetError is replaced.
#include "core/error.h"
#include "jobs/draw_image.h"
#include "jobs/scene_tools.h"
#include "screen/gl/gl.h"
#include "screen/method/method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

GLenum APIENTRY answer_lost() {
    return GL_CONTEXT_LOST;
}

TEST(LostContext, FailsWhatIsBeingDrawnAndWhatFollowsIsDrawnAgain) {
    const Scene scene = load_scene("pillar");
    const CameraFrame frame(find_view(scene, "main").camera, 96, 54);
    const std::vector<MethodDescriptor> methods = load_methods();
    const auto request_of = [&](const char* id) {
        MethodRequest request;
        request.method = &find_method(methods, id);
        request.parameters = request.method->values("default");
        return request;
    };
    const MethodRequest gtao = request_of("gtao"), ssao = request_of("ssao");
    SceneTools tools;
    tools.choose(scene);
    tools.ready_renderer().draw_gbuffer(frame, gbuffer_inputs());
    const MethodOutput before = draw_image(tools.ready_renderer(), gtao);

    gl::GetError = answer_lost;
    try {
        draw_image(tools.ready_renderer(), ssao);
        ADD_FAILURE() << "was drawn in a context that is lost";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), HasSubstr("the driver has lost its context"));
    }
    EXPECT_TRUE(tools.renderer().lost());
    EXPECT_EQ(draw_image(tools.ready_renderer(), gtao).visibility.pixels, before.visibility.pixels);
    EXPECT_FALSE(tools.renderer().lost());
    EXPECT_NO_THROW(draw_image(tools.ready_renderer(), ssao));
}

}  // namespace
}  // namespace aoscore
