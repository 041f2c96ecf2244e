#include "core/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 tilted(double from_zenith) {
    return {std::sin(from_zenith) * 0.6, std::cos(from_zenith), std::sin(from_zenith) * 0.8};
}

TEST(SkyCones, SeeTheSameInEveryDirectionOfAnEvenSky) {
    const SkyCones cones({.even = 0.7});
    for (const double tilt : {0.0, 0.4, 1.5, 3.0}) {
        for (const double cone : {0.0, 0.1, 0.8, kPi / 2})
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), cone), 0.7, 1e-12) << tilt << ", " << cone;
    }
}

// Integrating cos² over the cone: cos(tilt) 2/3 (1 - cos³ c) / sin² c, and cos(tilt) itself at c = 0.
TEST(SkyCones, FollowTheClosedFormUnderALinearGradient) {
    const SkyCones cones({.even = 1, .slope = 0.5});
    for (const double tilt : {0.0, 0.5, 1.2, 2.5}) {
        for (int k = 0; k <= 2 * SkyCones::kMaps; ++k) {
            const double cone = kPi / 2 * k / (2 * SkyCones::kMaps), cosine = std::cos(cone);
            const double mean = k == 0 ? 1 : 2.0 / 3 * (1 - cosine * cosine * cosine) / (1 - cosine * cosine);
            const double allowed = k % 2 == 0 ? 1e-3 : 4e-3;  // half-way between maps
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), cone), 1 + 0.5 * std::cos(tilt) * mean, allowed)
                << tilt << ", " << cone;
        }
    }
}

// A plane that is tilted by t sees the part (1 + cos t) / 2 of it.
TEST(SkyCones, FollowTheClosedFormUnderAHalfWhiteSky) {
    const SkyCones cones({.upper = 1});
    for (const double tilt : {0.0, kPi / 3, kPi / 2, 2.0, kPi})
        EXPECT_NEAR(cones.mean_radiance(tilted(tilt), kPi / 2), (1 + std::cos(tilt)) / 2, 0.01) << tilt;
}

TEST(GeneratedSky, GivesAnOpenFloorTheIrradiancePi) {
    const SkyCones cones(generated_sky());
    EXPECT_NEAR(cones.mean_radiance({0, 1, 0}, kPi / 2), 1, 1e-3);
    EXPECT_GT(cones.mean_radiance(generated_sky().glow_from, 0.2), 2) << "a glow that a bend can seek";
    EXPECT_LT(cones.mean_radiance({0, -1, 0}, kPi / 2), 0.5);
}

}  // namespace
}  // namespace aoscore
