#include "core/environment.h"

#include "core/environment_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

EnvironmentMap black(int height) {
    return {Image<glm::vec3>(2 * height, height, glm::vec3(0)), 0};
}

double power(const EnvironmentMap& map) {
    double sum = 0;
    for (int y = 0; y < map.radiance.height; ++y) {
        for (int x = 0; x < map.radiance.width; ++x)
            sum += map.solid_angle(y) * luminance(glm::dvec3(map.radiance.at(x, y)));
    }
    return sum;
}

/// One texel of a million times the radiance of the rest.
EnvironmentMap with_a_sun(int x, int y, int height = 64) {
    EnvironmentMap map{Image<glm::vec3>(2 * height, height, glm::vec3(1)), 0};
    map.radiance.at(x, y) = glm::vec3(1e6F, 9e5F, 5e5F);
    return map;
}

// The axes that README states, by hand: left, middle and right of the picture, upper and lower edge.
TEST(EnvironmentMap, HasItsMiddleTowardsXAndItsRightHalfTowardsZ) {
    const EnvironmentMap map = black(64);
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
    EXPECT_TRUE(near(map.direction(0.5, 0.5), {1, 0, 0}));
    EXPECT_TRUE(near(map.direction(0.75, 0.5), {0, 0, 1}));
    EXPECT_TRUE(near(map.direction(0.25, 0.5), {0, 0, -1}));
    EXPECT_TRUE(near(map.direction(0, 0.5), {-1, 0, 0}));
    EXPECT_TRUE(near(map.direction(0.3, 0), {0, 1, 0}));
    EXPECT_TRUE(near(map.direction(0.3, 1), {0, -1, 0}));
}

TEST(EnvironmentMap, TurnsCounterclockwiseSeenFromAbove) {
    EnvironmentMap map = black(64);
    map.turn_rad = kPi / 2;  // seen from above with +x to the right, -z is up
    EXPECT_LT(glm::length(map.direction(0.5, 0.5) - glm::dvec3(0, 0, -1)), 1e-12);
}

TEST(EnvironmentMap, FindsEveryTexelInItsOwnDirection) {
    for (const double turn : {0.0, 1.0, -4.0}) {
        EnvironmentMap map = black(16);
        map.turn_rad = turn;
        for (std::size_t i = 0; i < map.radiance.size(); ++i)
            map.radiance.pixels[i] = glm::vec3(static_cast<float>(i));
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 32; ++x) {
                const glm::dvec3 from = map.direction((x + 0.5) / 32, (y + 0.5) / 16);
                EXPECT_EQ(map.at(from).x, map.radiance.at(x, y).x) << x << ", " << y << ", " << turn;
            }
        }
    }
}

TEST(EnvironmentMap, HasTexelsThatCoverTheSphere) {
    const EnvironmentMap map = black(9);
    double sum = 0;
    for (int y = 0; y < 9; ++y) sum += 18 * map.solid_angle(y);
    EXPECT_NEAR(sum, 4 * kPi, 1e-9);
}

TEST(EnvironmentMap, KeepsItsPowerWhereItIsReduced) {
    for (const int height : {64, 60, 63}) {
        const EnvironmentMap map = with_a_sun(5, 3, height), small = map.reduced(32);
        EXPECT_NEAR(power(small) / power(map), 1, 1e-5);
        EXPECT_EQ(small.radiance.width, 2 * small.radiance.height);
    }
    EXPECT_EQ(with_a_sun(5, 3).reduced(32).radiance.width, 32);
}

TEST(Environment, HasADigestOfTheLightAndNotOfTheName) {
    const Environment a(with_a_sun(5, 3), "a"), b(with_a_sun(5, 3), "b"), c(with_a_sun(6, 3), "a");
    EXPECT_EQ(a.digest(), b.digest());
    EXPECT_NE(a.digest(), c.digest());
    EnvironmentMap turned = with_a_sun(5, 3);
    turned.turn_rad = 1;
    EXPECT_NE(a.digest(), Environment(turned, "a").digest());
    EXPECT_NE(Environment(Sky{.even = 1}).digest(), Environment(Sky{.even = 2}).digest());
}

TEST(EnvironmentPeaks, OfASkyAreNone) {
    EXPECT_TRUE(EnvironmentPeaks(generated_sky()).empty());
}

// The integral of a function of the direction over the peaks, by their samples, and over the rest, by texels,
// is that over all.
TEST(EnvironmentPeaks, AndTheRestAddUpToTheLight) {
    const EnvironmentMap map = with_a_sun(40, 20);
    const Environment environment(map, "sun");
    const EnvironmentPeaks peaks(environment);
    ASSERT_FALSE(peaks.empty());
    const auto weight = [](const glm::dvec3& from) { return 1.5 + from.x + 0.3 * from.z; };
    glm::dvec3 all(0), parts(0);
    for (int y = 0; y < map.radiance.height; ++y) {
        for (int x = 0; x < map.radiance.width; ++x) {
            const glm::dvec3 radiance(map.radiance.at(x, y));
            const double part = map.solid_angle(y) * weight(map.direction((x + 0.5) / 128, (y + 0.5) / 64));
            all += part * radiance;
            parts += part * peaks.rest(radiance);
        }
    }
    constexpr int kSide = 64;
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto sample = peaks.sample((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
        EXPECT_NEAR(glm::length(sample.from), 1, 1e-12);
        EXPECT_EQ(map.at(sample.from), map.radiance.at(40, 20)) << "within the texel";
        parts += weight(sample.from) * sample.radiance_by_chance / double{kSide * kSide};
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(parts[c] / all[c], 1, 1e-3) << c;
}

}  // namespace
}  // namespace aoscore
