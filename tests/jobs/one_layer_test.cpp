// Compares the ray march's occlusion in one depth layer with the ray tracer's one-layer bound.
#include "core/error.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace aoscore {
namespace {

constexpr double kRadius = 0.5;

/// Measures the RMSE of ray marches on the atrium's wide view, against the visibility that the visible
/// surfaces alone leave.
class MarchOfOneLayer : public ::testing::Test {
  protected:
    MarchOfOneLayer() {
        TruthSettings settings;
        settings.samples = 32;
        settings.extras.one_layer_bound = true;
        truth_ = ReferenceScene(scene_).trace(frame_, {{Falloff::binary, kRadius, 0}}, settings, "bound");
        renderer_.set_scene(scene_);
        renderer_.draw_gbuffer(frame_, {"normal_geometric"});
        surface_ = renderer_.read_gbuffer().surface;
    }

    double error(const char* preset, const ParameterValues& overrides) {
        MethodRequest request;
        request.method = &find_method(methods_, "ray-march");
        request.parameters = request.method->values(preset, overrides);
        const ImageF march = renderer_.run(request).raw;
        double squares = 0, count = 0;
        for (std::size_t i = 0; i < march.size(); ++i) {
            if (surface_.pixels[i] == 0 || truth_.hits.depth.pixels[i] <= 0) continue;
            squares += std::pow(march.pixels[i] - (1.0 - truth_.one_layer_bound.pixels[i]), 2);
            ++count;
        }
        return std::sqrt(squares / count);
    }

  private:
    Scene scene_ = load_scene("atrium");
    CameraFrame frame_{find_view(scene_, "wide").camera, 160, 90};
    std::vector<MethodDescriptor> methods_ = load_methods();
    ScreenRenderer renderer_;
    Truth truth_;
    Mask surface_;
};

TEST_F(MarchOfOneLayer, IsNearestToTheTracedBoundByDefault) {
    const double by_default = error("default", {{"radius", kRadius}});
    EXPECT_LT(by_default, 0.5 * error("solid", {{"radius", kRadius}}));
    for (const double thickness : {0.0, kRadius, 10 * kRadius}) {
        EXPECT_LT(by_default, error("default", {{"radius", kRadius}, {"thickness", thickness}})) << thickness;
    }
}

}  // namespace
}  // namespace aoscore
