// Holds depth layers that rays meet against those that the rasteriser peels off.
#include "core/error.h"
#include "jobs/scene_tools.h"
#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr int kLayers = 9;  // the first, and the eight behind it that rays look at

// Where surfaces touch, and along edges, the two see them in other orders.
TEST(RayLayersOfAScene, AreThoseThatPassesPeelOff) {
    for (const auto& [name, view] : {std::pair("atrium", "wide"), std::pair("pillar", "main")}) {
        const Scene scene = load_scene(name);
        const CameraFrame frame(find_view(scene, view).camera, 160, 90);
        SceneTools tools;
        tools.choose(scene);
        ScreenRenderer& renderer = tools.ready_renderer();
        renderer.draw_gbuffer(frame, {});
        const auto drawn = [&](const char* sampling) {
            renderer.draw_depth_layers({.samples = kLayers, .sampling = sampling});
            return renderer.read_depth_layers();
        };
        const std::vector<ImageF> peeled = drawn("peeled"), met = drawn("rays");
        ASSERT_EQ(met.size(), peeled.size());
        std::size_t same = 0, deeper = 0;
        for (std::size_t i = 0; i < peeled[0].size(); ++i) {
            bool agrees = true;
            for (std::size_t layer = 0; layer < kLayers; ++layer) {
                const float a = peeled[layer].pixels[i], b = met[layer].pixels[i];
                agrees = agrees && std::abs(a - b) <= 1e-4F * a;
                deeper += layer > 0 && b < static_cast<float>(frame.camera().far) ? 1 : 0;
            }
            same += agrees ? 1 : 0;
        }
        EXPECT_GT(static_cast<double>(same), 0.9 * static_cast<double>(peeled[0].size())) << name;
        EXPECT_GT(deeper, peeled[0].size()) << name;
    }
}

TEST(RayLayersOfAScene, AreRefusedWhereNobodyTraces) {
    const Scene scene = load_scene("pillar");
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(CameraFrame(find_view(scene, "main").camera, 32, 18), {});
    try {
        renderer.draw_depth_layers({.samples = 2, .sampling = "rays"});
        FAIL() << "layers by rays without a ray tracer";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), ::testing::HasSubstr("need a ray tracer"));
    }
}

// The job hands the tracer's depths to the shader: with room for all of them it finds what it finds over
// peeled layers.
TEST(RayLayersOfAScene, GiveAMethodWhatPeeledLayersGive) {
    const Scene scene = load_scene("pillar");
    SceneTools tools;
    tools.choose(scene);
    ScreenRenderer& renderer = tools.ready_renderer();
    renderer.draw_gbuffer(CameraFrame(find_view(scene, "main").camera, 160, 90), gbuffer_inputs());
    const std::vector<MethodDescriptor> methods = load_methods();
    const auto occlusion = [&](const char* sampling, int samples) {
        MethodRequest request;
        request.method = &find_method(methods, "sd-hbao-plus");
        request.parameters =
            request.method->values("default", {{"sampling", sampling}, {"depth_samples", samples}});
        double sum = 0;
        for (const float v : renderer.run(request).raw.pixels) sum += 1 - static_cast<double>(v);
        return sum / (160 * 90);
    };
    const double one = occlusion("peeled", 1), all = occlusion("peeled", kLayers);
    EXPECT_GT(all, 1.05 * one);
    EXPECT_NEAR(occlusion("rays", 1), one, 0.002 * one);
    EXPECT_NEAR(occlusion("rays", kLayers), all, 0.02 * all);
    const double some = occlusion("rays", 2);
    EXPECT_GT(some, one);
    EXPECT_LT(some, all);
}

}  // namespace
}  // namespace aoscore
