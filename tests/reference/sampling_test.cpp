#include "core/sampling.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace aoscore {
namespace {

struct Point {
    std::uint32_t u, v;
};

std::vector<Point> scrambled(std::uint32_t count, std::uint64_t seed) {
    const std::uint64_t bits = mix_bits(seed);
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        points.push_back(
            {owen_scramble_reversed(i, static_cast<std::uint32_t>(bits)),
             owen_scramble_reversed(sobol_y_reversed(i), static_cast<std::uint32_t>(bits >> 32))});
    }
    return points;
}

TEST(Sampling, ScrambledPointsKeepOnePointInEveryElementaryInterval) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (const unsigned log_count : {0u, 1u, 4u, 7u, 10u}) {
            const std::vector<Point> points = scrambled(1u << log_count, seed);
            for (unsigned a = 0; a <= log_count; ++a) {
                std::set<std::uint64_t> cells;
                for (const Point& p : points) {
                    cells.insert(((std::uint64_t{p.u} << 32) >> (64 - a) << 32) |
                                 ((std::uint64_t{p.v} << 32) >> (64 - (log_count - a))));
                }
                ASSERT_EQ(cells.size(), points.size()) << "seed " << seed << ", 2^" << log_count << " points";
            }
        }
    }
}

TEST(Sampling, EveryScrambledPointIsUniformOverSeeds) {
    // 64 cells, 6400 seeds: chi-squared with 63 degrees of freedom has a standard deviation of 11.2.
    for (const std::uint32_t index : {0u, 1u, 5u, 63u, 1000u}) {
        std::vector<int> counts(64);
        for (std::uint64_t seed = 0; seed < 6400; ++seed) {
            const std::uint64_t bits = mix_bits(seed);
            const std::uint32_t u = owen_scramble_reversed(index, static_cast<std::uint32_t>(bits));
            const std::uint32_t v =
                owen_scramble_reversed(sobol_y_reversed(index), static_cast<std::uint32_t>(bits >> 32));
            ++counts[(u >> 29) * 8 + (v >> 29)];
        }
        double chi_squared = 0;
        for (const int count : counts) chi_squared += (count - 100.0) * (count - 100.0) / 100;
        EXPECT_LT(chi_squared, 63 + 4.5 * 11.2) << "index " << index;
    }
}

TEST(Sampling, CosineHemisphereHasTheMomentsOfTheCosine) {
    // E z = 2/3, E z^2 = 1/2, E x = E y = E xy = 0, E x^2 = E y^2 = 1/4.
    constexpr int kSide = 512;
    double z = 0, zz = 0, x = 0, y = 0, xy = 0, xx = 0;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const glm::vec3 d = cosine_hemisphere((i + 0.5f) / kSide, (j + 0.5f) / kSide);
            ASSERT_NEAR(glm::dot(d, d), 1, 1e-6);
            ASSERT_GT(d.z, 0);
            z += d.z;
            zz += d.z * d.z;
            x += d.x;
            y += d.y;
            xy += d.x * d.y;
            xx += d.x * d.x;
        }
    }
    constexpr double n = kSide * kSide;
    EXPECT_NEAR(z / n, 2.0 / 3, 1e-4);
    EXPECT_NEAR(zz / n, 0.5, 1e-5);
    EXPECT_NEAR(xx / n, 0.25, 1e-5);
    EXPECT_NEAR(x / n, 0, 1e-6);
    EXPECT_NEAR(y / n, 0, 1e-6);
    EXPECT_NEAR(xy / n, 0, 1e-6);
}

TEST(Sampling, FramesAreRightHandedAndOrthonormal) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const std::uint64_t bits = mix_bits(i);
        const double z =
            i < 2 ? (i == 0 ? 1.0 : -1.0) : unit_interval(static_cast<std::uint32_t>(bits)) * 2.0 - 1;
        const double phi = static_cast<double>(bits >> 40);
        const double r = std::sqrt(1 - z * z);
        const glm::dmat3 frame = frame_about({r * std::cos(phi), r * std::sin(phi), z});
        EXPECT_NEAR(glm::determinant(frame), 1, 1e-12);
        EXPECT_NEAR(glm::length(glm::transpose(frame)[0]), 1, 1e-12);
        EXPECT_EQ(frame[2].z, z);
    }
}

}  // namespace
}  // namespace aoscore
