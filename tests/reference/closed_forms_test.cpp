#include "scene/builtin/closed_forms.h"

#include "reference/test_scenes.h"
#include "reference/truth.h"
#include "scene/builtin/generators.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace aoscore {
namespace {

using closed_form::kNoCutoff;

struct Case {
    const char* scene;
    Scene (*generate)();
    double radius_m;
    glm::dvec3 position, target;
};

const std::array kCases = {
    Case{"wall", builtin::generate_wall, kNoCutoff, {2.5, 3, 1}, {0.8, 0, 0}},
    Case{"wall", builtin::generate_wall, 0.8, {2.5, 3, 1}, {0.6, 0, 0}},
    Case{"wall_tall", builtin::generate_wall_tall, kNoCutoff, {3.5, 4, 1}, {1.5, 0, 0}},
    Case{"sphere", builtin::generate_sphere, kNoCutoff, {3, 2, 1}, {0.3, 0, 0}},
    Case{"pit", builtin::generate_pit, kNoCutoff, {0.1, 3, 0.1}, {0, 0, 0}},
};

/// Errors over many pixels in units of their stated standard errors. One pixel's score has heavier tails than
/// a normal one, since its error is estimated from few blocks; the sums over pixels are close to normal.
struct Scores {
    int pixels = 0;
    double error_sum = 0, squared_error_sum = 0, variance_sum = 0;
    int beyond_three = 0;
    double largest_error = 0;
};

Scores score(const Case& c, int width, int height, int samples, const testing::Similarity& by = {},
             std::uint64_t seed = 1) {
    const ReferenceScene reference(testing::moved(c.generate(), by));
    const Camera camera = testing::looking(c.position, c.target);
    const CameraFrame frame(testing::moved(camera, by), width, height);
    TruthSettings settings;
    settings.samples = samples;
    settings.seed = seed;
    const Truth truth =
        reference.trace(frame, {{Falloff::binary, c.radius_m * by.scale, 0}}, settings, c.scene);
    const CameraFrame still(camera, width, height);
    Scores scores;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (truth.hits.surface.at(x, y) == 0) continue;
            const CameraFrame::Ray ray = still.ray(x + 0.5, y + 0.5);
            const glm::dvec3 point = ray.origin + ray.direction * (truth.hits.depth.at(x, y) / by.scale);
            const auto expected = closed_form::expected_visibility(c.scene, point, c.radius_m);
            if (!expected) continue;
            const double error = truth.visibility[0].at(x, y) - *expected;
            const double se = truth.standard_error[0].at(x, y);
            ++scores.pixels;
            scores.error_sum += error;
            scores.squared_error_sum += error * error;
            scores.variance_sum += se * se;
            scores.beyond_three += std::abs(error) > 3 * se ? 1 : 0;
            scores.largest_error = std::max(scores.largest_error, std::abs(error));
        }
    }
    return scores;
}

void expect_agreement(const Scores& s, int least_pixels) {
    EXPECT_GE(s.pixels, least_pixels);
    EXPECT_LE(std::abs(s.error_sum), 3 * std::sqrt(s.variance_sum)) << "biased by " << s.error_sum / s.pixels;
    EXPECT_LE(s.beyond_three, 0.08 * s.pixels);
    EXPECT_LE(s.squared_error_sum, 1.3 * s.variance_sum) << "the standard errors are too small";
}

TEST(ClosedForms, AgreeWithinThreeStandardErrors) {
    for (const Case& c : kCases) {
        SCOPED_TRACE(::testing::Message() << c.scene << " R=" << c.radius_m);
        expect_agreement(score(c, 48, 40, 128), 300);
    }
}

TEST(ClosedForms, AgreeAtEveryScalePlaceAndOrientation) {
    const std::array moves = {testing::Similarity{1e-3, {1, 2, 3}, 0.7, {0, 0, 0}},
                              testing::Similarity{1e5, {-1, 0.5, 0.2}, 2.1, {0, 0, 0}},
                              testing::Similarity{1, {0.3, 1, -0.4}, 4.0, {1e6, -1e6, 5e5}}};
    for (const testing::Similarity& by : moves) {
        testing::Similarity unit = by;
        unit.axis = glm::normalize(by.axis);
        for (const Case& c : kCases) {
            SCOPED_TRACE(::testing::Message() << c.scene << " R=" << c.radius_m << " scale " << by.scale);
            expect_agreement(score(c, 32, 24, 64, unit), 100);
        }
    }
}

TEST(ClosedForms, AreWithinTwoThousandthsAt16384Samples) {
    for (const double scale : {1e-3, 1.0, 1e5}) {
        for (const Case& c : kCases) {
            SCOPED_TRACE(::testing::Message() << c.scene << " R=" << c.radius_m << " scale " << scale);
            const Scores s = score(c, 7, 5, 16384, {scale, {0, 1, 0}, 0.3, {0, 0, 0}});
            EXPECT_GE(s.pixels, 8);
            EXPECT_LE(s.largest_error, 0.002);
        }
    }
}

}  // namespace
}  // namespace aoscore
