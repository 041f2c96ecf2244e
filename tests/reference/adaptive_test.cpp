#include "reference/benchmark/random_tiles.h"
#include "reference/sampling/sample_plan.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace aoscore {
namespace {

TruthSettings up_to(double max_error, std::uint64_t seed = 1) {
    TruthSettings settings;
    settings.samples = 16;
    settings.max_error = max_error;
    settings.seed = seed;
    return settings;
}

const std::vector<TruthQuery> kOneMetre = {{Falloff::binary, 1, 0}};

Truth accurate(const ReferenceScene& reference, const CameraFrame& frame) {
    TruthSettings settings;
    settings.samples = 16384;
    settings.seed = 99;
    return reference.trace(frame, kOneMetre, settings, "accurate");
}

/// Sums over the pixels with a surface, of one or several truths.
struct ErrorSums {
    double bias = 0, squared = 0, stated = 0, pixels = 0;
    void add(const Truth& truth, const Truth& exact) {
        for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
            if (truth.hits.surface.pixels[i] == 0) continue;
            const double error = truth.visibility[0].pixels[i] - exact.visibility[0].pixels[i];
            bias += error;
            squared += error * error;
            stated += std::pow(truth.standard_error[0].pixels[i], 2);
            ++pixels;
        }
    }
    void expect_honest(double error) const {
        EXPECT_LT(std::abs(bias / pixels), error / 10);
        EXPECT_LT(std::sqrt(squared / stated), 1.1) << "stated errors are too small";
    }
};

TEST(AdaptiveTracing, ReachesTheErrorInEveryPixelWithoutBias) {
    const ReferenceScene reference(testing::thicket());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 64, 48);
    const Truth exact = accurate(reference, frame);
    for (const double max_error : {0.02, 0.01}) {
        constexpr int kSeeds = 12;
        ErrorSums errors;
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            const Truth truth = reference.trace(frame, kOneMetre, up_to(max_error, seed), "adaptive");
            errors.add(truth, exact);
            float worst = 0;
            std::uint64_t rays = 0;
            for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
                if (truth.hits.surface.pixels[i] == 0) continue;
                worst = std::max(worst, truth.standard_error[0].pixels[i]);
                rays += truth.sample_counts.pixels[i];
            }
            EXPECT_LE(worst, max_error);
            EXPECT_EQ(truth.rays, rays);
        }
        errors.expect_honest(max_error);
    }
}

TEST(AdaptiveTracing, SpendsRaysWhereTheErrorIs) {
    const ReferenceScene reference(testing::still_life());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.6, 0}), 64, 48);
    TruthSettings settings = up_to(0.01);
    settings.skip_open = false;
    const Truth truth = reference.trace(frame, kOneMetre, settings, "adaptive");
    const auto& counts = truth.sample_counts.pixels;
    const std::uint32_t most = *std::max_element(counts.begin(), counts.end());
    std::uint32_t least = most;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (truth.hits.surface.pixels[i] != 0) least = std::min(least, counts[i]);
    }
    EXPECT_GE(least, 200u);  // 2 / E
    EXPECT_GE(most, 2 * least);
    EXPECT_GT(truth.samples, static_cast<int>(least));
    EXPECT_LT(truth.samples, static_cast<int>(most));
}

TEST(AdaptiveTracing, IsNotFooledByALuckyStart) {
    // A blade seen from a floor point covers about three hundredths of the cosine: three times the error
    // asked for. No pixel of many seeds may come out as open.
    constexpr double kMaxError = 0.01;
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(5, 1));
    testing::add(scene, testing::quad({-0.05, 1, -0.9}, {0.05, 1, -0.9}, {0.05, 1, 0.9}, {-0.05, 1, 0.9}));
    const ReferenceScene reference(scene);
    Camera camera = testing::looking({0, 0.9, 0.01}, {0, 0, 0});
    camera.fovy_rad = 0.3;
    const CameraFrame frame(camera, 24, 24);
    const TruthQuery query{Falloff::binary, 2, 0};
    TruthSettings settings;
    settings.samples = 16384;
    const Truth exact = reference.trace(frame, {query}, settings, "exact");
    EXPECT_LT(*std::max_element(exact.visibility[0].pixels.begin(), exact.visibility[0].pixels.end()),
              0.975f);
    int fooled = 0;
    double squared = 0;
    constexpr int kSeeds = 30;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Truth truth = reference.trace(frame, {query}, up_to(kMaxError, seed), "thin");
        for (std::size_t i = 0; i < truth.visibility[0].size(); ++i) {
            const double error = truth.visibility[0].pixels[i] - exact.visibility[0].pixels[i];
            squared += error * error / (kSeeds * static_cast<double>(truth.visibility[0].size()));
            fooled += truth.visibility[0].pixels[i] == 1.0f;
        }
    }
    EXPECT_EQ(fooled, 0);
    EXPECT_LT(std::sqrt(squared), kMaxError);
}

TEST(TracingToAMeanError, ReachesItWithFewerRaysThanTheSameForAll) {
    const ReferenceScene reference(testing::still_life());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.6, 0}), 200, 150);
    const Truth exact = accurate(reference, frame);
    for (const double mean_error : {0.01, 0.005}) {
        TruthSettings settings;
        settings.samples = 16;
        settings.mean_error = mean_error;
        const Truth truth = reference.trace(frame, kOneMetre, settings, "mean");
        EXPECT_NEAR(mean_standard_error(truth), mean_error, 0.05 * mean_error);
        ErrorSums errors;
        errors.add(truth, exact);
        errors.expect_honest(mean_error);
        settings.mean_error = 0;
        settings.samples = truth.samples;
        EXPECT_GT(mean_standard_error(reference.trace(frame, kOneMetre, settings, "even")),
                  1.05 * mean_error);
    }
}

TEST(TracingToAMeanError, GivesAllPixelsOfATileTheSame) {
    const ReferenceScene reference(testing::thicket());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 64, 48);
    TruthSettings settings;
    settings.samples = 24;
    settings.mean_error = 0.01;
    const Truth truth = reference.trace(frame, kOneMetre, settings, "mean");
    std::uint32_t fewest = kMostSamples, most = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const std::uint32_t count = truth.sample_counts.at(x, y);
            if (count == 0) continue;
            EXPECT_TRUE(std::has_single_bit(count));
            fewest = std::min(fewest, count);
            most = std::max(most, count);
            for (int from = x & ~7; from < x; ++from) {
                const std::uint32_t other = truth.sample_counts.at(from, y);
                EXPECT_TRUE(other == 0 || other == count) << x << ", " << y;
            }
        }
    }
    EXPECT_GE(fewest, 32u);
    EXPECT_GE(most, 4 * fewest);
}

TEST(TracingToAMeanError, LeapsWhereDoublingWouldComeAnyway) {
    TruthSettings settings;
    settings.samples = 64;
    settings.mean_error = 0.004;
    const SamplePlan plan(settings, {.least_gain = 1e-5});
    EXPECT_EQ(plan.next_of_tile(64, 64e-5), 64) << "gains no more than the least";
    EXPECT_EQ(plan.next_of_tile(64, 65e-5), 128);
    EXPECT_EQ(plan.next_of_tile(64, 64 * 12e-5), 256) << "128 would gain more than 3 times the least";
    EXPECT_EQ(plan.next_of_tile(plan.most(), 1), plan.most());
}

TEST(AdaptiveTracing, PlansGrowTowardsTheErrorAndEnd) {
    TruthSettings settings = up_to(0.004);
    const SamplePlan plan(settings);
    EXPECT_EQ(plan.first(), 512);
    EXPECT_EQ(plan.next(512, 0.004), 512);
    EXPECT_GT(plan.next(512, 0.0041), 512);
    EXPECT_EQ(plan.next(512, 0.5), 2048);
    EXPECT_EQ(plan.next(plan.most(), 0.5), plan.most());
    EXPECT_GE(plan.most(), 15625);
    settings.max_error = 0;
    EXPECT_EQ(SamplePlan(settings).first(), 16);
    EXPECT_EQ(SamplePlan(settings).next(16, 0.5), 16);
}

}  // namespace
}  // namespace aoscore
