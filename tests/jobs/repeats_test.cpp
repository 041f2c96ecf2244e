// What drawing a cell again finds, on a scene whose occluder hides behind a pillar.
#include "jobs/repeats.h"

#include "core/signal.h"
#include "metrics/analysis/repeat_values.h"
#include "metrics/roles.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace aoscore {
namespace {

class RepeatedImages : public ::testing::Test {
  protected:
    RepeatedImages() {
        TruthSettings settings;
        settings.samples = 32;
        settings.extras.causes = settings.extras.bent_normals = true;
        truth_ = ReferenceScene(scene_).trace(frame_, {{Falloff::binary, 0.5, 0}}, settings, "repeats");
        renderer_.set_scene(scene_);
        renderer_.draw_gbuffer(frame_, gbuffer_inputs());
        ground_ = find_ground(frame_, truth_, renderer_.read_gbuffer(), scene_.bounds);
    }

    MethodRequest request(const char* method, const ParameterValues& overrides) const {
        MethodRequest request;
        request.method = &find_method(methods_, method);
        request.parameters = request.method->values("default", overrides);
        return request;
    }
    Repeats repeated(const char* method, const ParameterValues& overrides) {
        return repeat_image(renderer_, {request(method, overrides), {}}, truth_, ground_, drawn_);
    }
    double layers_found(const ParameterValues& overrides) {
        return found_share(repeated("sd-hbao-plus", overrides).of_layers).value();
    }

    Scene scene_ = load_scene("pillar");
    CameraFrame frame_{find_view(scene_, "main").camera, 160, 90};
    std::vector<MethodDescriptor> methods_ = load_methods();
    ScreenRenderer renderer_;
    Truth truth_;
    Ground ground_;
    LayersDrawn drawn_;
};

TEST_F(RepeatedImages, FindAllOverAllLayersAndNothingOverTheFirst) {
    EXPECT_NEAR(layers_found({{"sampling", "peeled"}, {"depth_samples", 16}}), 1, 1e-6);
    EXPECT_NEAR(layers_found({{"alpha", 1.0}, {"depth_samples", 1}}), 0, 0.01)
        << "but for its strength's fit";
    const double some = layers_found({{"depth_samples", 8}});
    EXPECT_GT(some, 0.2);
    EXPECT_LT(some, 1.5);
    EXPECT_EQ(drawn_.by_digest.size(), 1u) << "the layers were drawn once for all of them";
}

TEST_F(RepeatedImages, OfAMethodWithoutLayersFindOfTheTruthAlone) {
    const Repeats repeats = repeated("hbao-plus", {});
    EXPECT_FALSE(repeats.of_layers);
    ASSERT_TRUE(repeats.of_truth);
    EXPECT_GT(repeats.of_truth->strength, 1) << "HBAO+ is faint without a strength";
}

TEST_F(RepeatedImages, HaveNoNoiseWhereNoSeedMatters) {
    EXPECT_EQ(noise_over_seeds(repeated("hbao-plus", {{"noise", "none"}})), 0);
    EXPECT_GT(*noise_over_seeds(repeated("hbao-plus", {{"noise", "hash"}})), 0.001);
}

TEST_F(RepeatedImages, HoldSignalsAgainstTheTruthWhereOcclusionIsHiddenAndWhereNot) {
    MethodRequest asked = request("hbao", {});
    asked.signals = further_signals();
    const Repeats repeats = repeat_image(renderer_, {asked, {}}, truth_, ground_, drawn_);
    const double hidden = repeats.hidden_signals.at("cone_angle").at(kConeBiasMetric).value.value();
    const double other = repeats.other_signals.at("cone_angle").at(kConeBiasMetric).value.value();
    EXPECT_GT(hidden, other) << "cones are too wide where the occluder is not seen";
    const AngleBlocks& cones = repeats.hidden_angles.at("cone_angle");
    EXPECT_NEAR(*ratio_of_sums(cones.signed_sums, cones.counts), hidden, 1e-9);
    EXPECT_NEAR(*ratio_of_sums(cones.absolute_sums, cones.counts),
                *repeats.hidden_signals.at("cone_angle").at(kConeErrorMetric).value, 1e-9);
    const AngleBlocks& normals = repeats.other_angles.at("bent_normal");
    EXPECT_NEAR(*ratio_of_sums(normals.absolute_sums, normals.counts),
                *repeats.other_signals.at("bent_normal").at(kBentAngleMetric).value, 1e-9);
}

TEST_F(RepeatedImages, SurviveTheStore) {
    const Repeats repeats = repeated("sd-hbao-plus", {{"depth_samples", 4}});
    const Repeats back = repeats_from_json(to_json(repeats), "test");
    EXPECT_EQ(back.variance, repeats.variance);
    EXPECT_EQ(back.of_layers->found_fitted, repeats.of_layers->found_fitted);
    EXPECT_EQ(back.of_truth->strength, repeats.of_truth->strength);
}

}  // namespace
}  // namespace aoscore
