#include "jobs/contest/few_rays.h"

#include "jobs/scene_tools.h"
#include "plan/resolved_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

class FewRays : public ::testing::Test {
  protected:
    FewRays() { tools.choose(scene); }

    MethodRequest asked(int rays) const {
        MethodRequest request;
        request.method = &method;
        request.parameters = method.values("default", {{"rays", rays}, {"radius", 1.0}});
        return request;
    }

    ImageF traced(int rays) { return trace_few_rays(tools.reference(), frame, asked(rays)); }

    /// Every request has the seed 1, as this truth has, so that shared rays would show.
    Truth truth(int samples) {
        TruthSettings settings;
        settings.samples = samples;
        return tools.reference().trace(frame, {{Falloff::binary, 1.0, 0}}, settings, "truth");
    }

    const Scene scene = load_scene("wall");
    const CameraFrame frame{find_view(scene, "oblique").camera, 160, 90};
    const MethodDescriptor method = few_rays_descriptor();
    SceneTools tools;
};

// A ray hits or does not, so that one ray errs by V(1 - V) in the mean square, whatever the scene.
TEST_F(FewRays, OneRayErrsAsACoinThatFallsOpenAsOftenAsTheTruthIs) {
    const Truth exact = truth(1024);
    const ImageF one = traced(1);
    double error = 0, coin = 0, mean = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (exact.hits.surface.pixels[i] == 0) continue;
        const double v = static_cast<double>(exact.visibility[0].pixels[i]);
        const double found = static_cast<double>(one.pixels[i]);
        ASSERT_TRUE(found == 0 || found == 1);
        error += (found - v) * (found - v);
        mean += found - v;
        coin += v * (1 - v);
    }
    ASSERT_GT(coin, 100) << "a picture with nothing to hit tells nothing";
    EXPECT_NEAR(error / coin, 1, 0.1);
    EXPECT_LT(std::abs(mean), 4 * std::sqrt(coin)) << "unbiased";
}

// Were its rays among the truth's own, four of the truth's eight would agree with it.
TEST_F(FewRays, ShareNothingWithATruthOfTheSameSeed) {
    const Truth exact = truth(1024), coarse = truth(8);
    const ImageF few = traced(8);
    double product = 0, truths = 0, theirs = 0;
    for (std::size_t i = 0; i < few.size(); ++i) {
        const double v = static_cast<double>(exact.visibility[0].pixels[i]);
        const double a = static_cast<double>(coarse.visibility[0].pixels[i]) - v;
        const double b = static_cast<double>(few.pixels[i]) - v;
        product += a * b;
        truths += a * a;
        theirs += b * b;
    }
    EXPECT_LT(std::abs(product) / std::sqrt(truths * theirs), 0.05);
}

TEST_F(FewRays, AreFilteredAsAMethodsOwnPictureIs) {
    ScreenRenderer& renderer = tools.ready_renderer();
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const Registry registry = load_registry();
    MethodRequest request;
    request.method = &find_method(registry.methods, "ssao");
    request.parameters = request.method->values("default");
    for (const MethodDescriptor& filter : registry.filters) {
        request.filter = &filter;
        request.filter_parameters = filter.values("default");
        const MethodOutput output = renderer.run(request);
        EXPECT_EQ(renderer.filter(output.raw, request).pixels, output.visibility.pixels) << filter.id;
    }
    EXPECT_ANY_THROW(renderer.filter(ImageF(8, 8, 1.0F), request)) << "of another size";
}

}  // namespace
}  // namespace aoscore
