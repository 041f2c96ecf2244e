#include "core/environment_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 tilted(double from_zenith) {
    return {std::sin(from_zenith) * 0.6, std::cos(from_zenith), std::sin(from_zenith) * 0.8};
}

TEST(ConesOfASky, SeeTheSameInEveryDirectionOfAnEvenSky) {
    const EnvironmentCones cones(Sky{.even = 0.7});
    for (const double tilt : {0.0, 0.4, 1.5, 3.0}) {
        for (const double cone : {0.0, 0.1, 0.8, kPi / 2})
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), cone).y, 0.7, 1e-12) << tilt << ", " << cone;
    }
}

// Integrating cos² over the cone: cos(tilt) 2/3 (1 - cos³ c) / sin² c, and cos(tilt) itself at c = 0.
TEST(ConesOfASky, FollowTheClosedFormUnderALinearGradient) {
    const EnvironmentCones cones(Sky{.even = 1, .slope = 0.5});
    for (const double tilt : {0.0, 0.5, 1.2, 2.5}) {
        for (int k = 0; k <= 2 * EnvironmentCones::kMaps; ++k) {
            const double cone = kPi / 2 * k / (2 * EnvironmentCones::kMaps), cosine = std::cos(cone);
            const double mean = k == 0 ? 1 : 2.0 / 3 * (1 - cosine * cosine * cosine) / (1 - cosine * cosine);
            const double allowed = k % 2 == 0 ? 1e-3 : 4e-3;  // half-way between maps
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), cone).y, 1 + 0.5 * std::cos(tilt) * mean, allowed)
                << tilt << ", " << cone;
        }
    }
}

// A plane that is tilted by t sees the part (1 + cos t) / 2 of it.
TEST(ConesOfASky, FollowTheClosedFormUnderAHalfWhiteSky) {
    const EnvironmentCones cones(Sky{.upper = 1});
    for (const double tilt : {0.0, kPi / 3, kPi / 2, 2.0, kPi})
        EXPECT_NEAR(cones.mean_radiance(tilted(tilt), kPi / 2).y, (1 + std::cos(tilt)) / 2, 0.01) << tilt;
}

/// A picture of any light.
template <class Light>
Environment picture_of(int height, const Light& light, double turn_rad = 0) {
    EnvironmentMap map{Image<glm::vec3>(2 * height, height), turn_rad};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const glm::dvec3 from = map.direction((x + 0.5) / (2 * height), (y + 0.5) / height);
            map.radiance.at(x, y) = glm::vec3(light(from));
        }
    }
    return {std::move(map), "picture"};
}

TEST(ConesOfAPicture, SeeTheSameInEveryDirectionOfAnEvenOne) {
    for (const int height : {1, 7, 64, 512}) {
        const EnvironmentCones cones(
            picture_of(height, [](const glm::dvec3&) { return glm::dvec3(1, 2, 3); }));
        for (const double tilt : {0.0, 0.4, 1.5, 3.0}) {
            for (const double cone : {0.0, 0.1, 0.8, kPi / 2}) {
                const glm::dvec3 mean = cones.mean_radiance(tilted(tilt), cone);
                EXPECT_NEAR(glm::length(mean - glm::dvec3(1, 2, 3)), 0, 1e-6) << height << ", " << tilt;
            }
        }
    }
}

// The same closed form as of a sky, along an axis that lies level, so that a mirrored or turned picture
// fails.
TEST(ConesOfAPicture, FollowTheClosedFormUnderALinearGradient) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.3, 0.2, -0.9));
    const EnvironmentCones cones(
        picture_of(256, [&](const glm::dvec3& from) { return glm::dvec3(1 + 0.5 * glm::dot(from, up)); }));
    for (const double tilt : {0.0, 0.5, 1.2, 2.5}) {
        for (int k = 0; k <= EnvironmentCones::kMaps; ++k) {
            const double cone = kPi / 2 * k / EnvironmentCones::kMaps, cosine = std::cos(cone);
            const double mean = k == 0 ? 1 : 2.0 / 3 * (1 - cosine * cosine * cosine) / (1 - cosine * cosine);
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), cone).x,
                        1 + 0.5 * glm::dot(tilted(tilt), up) * mean, 4e-3)
                << tilt << ", " << cone;
        }
    }
}

// The lower half is white. A surface tilted by t sees the part (1 - cos t) / 2 of it, however few texels there
// are: they are areas, not points.
TEST(ConesOfAPicture, FollowTheClosedFormUnderFewTexels) {
    for (const int height : {2, 4, 8, 16, 32}) {
        const EnvironmentCones cones(
            picture_of(height, [](const glm::dvec3& from) { return glm::dvec3(from.y < 0 ? 1 : 0); }));
        for (const double tilt : {0.0, 0.38, kPi / 3, kPi / 2, 2.0, kPi}) {
            EXPECT_NEAR(cones.mean_radiance(tilted(tilt), kPi / 2).y, (1 - std::cos(tilt)) / 2, 2e-3)
                << height << ", " << tilt;
        }
    }
}

TEST(ConesOfAPicture, OfTheGeneratedSkyAreThoseOfItsTerms) {
    const EnvironmentCones terms(generated_sky());
    const EnvironmentCones texels(
        picture_of(256, [](const glm::dvec3& from) { return glm::dvec3(generated_sky().radiance(from)); }));
    for (const double tilt : {0.0, 0.6, 1.4, 2.2, 3.1}) {
        for (const double cone : {0.3, 0.8, kPi / 2}) {
            EXPECT_NEAR(texels.mean_radiance(tilted(tilt), cone).x, terms.mean_radiance(tilted(tilt), cone).x,
                        0.02)
                << tilt << ", " << cone;
        }
    }
}

TEST(GeneratedSky, GivesAnOpenFloorTheIrradiancePi) {
    const EnvironmentCones cones(generated_sky());
    EXPECT_NEAR(cones.mean_radiance({0, 1, 0}, kPi / 2).y, 1, 1e-3);
    EXPECT_GT(cones.mean_radiance(generated_sky().glow_from, 0.2).y, 2) << "a glow that a bend can seek";
    EXPECT_LT(cones.mean_radiance({0, -1, 0}, kPi / 2).y, 0.5);
}

}  // namespace
}  // namespace aoscore
