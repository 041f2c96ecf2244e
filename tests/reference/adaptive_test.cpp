#include "core/error.h"
#include "core/threads.h"
#include "reference/benchmark/random_tiles.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/tile_store.h"
#include "reference/sampling/pilot.h"
#include "reference/sampling/sample_plan.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

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

TruthSettings to_mean_error(double mean_error, std::uint64_t seed = 1) {
    TruthSettings settings = up_to(0, seed);
    settings.mean_error = mean_error;
    return settings;
}

TEST(TracingToAMeanError, ReachesItWhateverTheSceneAndTheSeed) {
    // So small pictures have few tiles, and counts are whole numbers.
    constexpr double kAllowed = 0.045;
    for (const char* id : {"atrium", "cathedral", "pillar", "railing", "vault", "yard"}) {
        const Scene scene = load_scene(id);
        const View& view = scene.views.front();
        const ReferenceScene reference = ReferenceScene::built_when_needed(scene);
        const CameraFrame frame(view.camera, 192, 108);
        const std::vector<TruthQuery> query = {{Falloff::binary, view.radius_m.value_or(1), 0}};
        for (const double mean_error : {0.02, 0.01}) {
            for (std::uint64_t seed = 1; seed <= 2; ++seed) {
                const Truth truth =
                    reference.trace(frame, query, to_mean_error(mean_error, seed), "to a mean error");
                const double reached = mean_standard_error(truth);
                EXPECT_LT(reached, (1 + kAllowed) * mean_error) << id << ", seed " << seed;
                // Few rays can be enough by far, and proofs at 64 rays a leap.
                if (truth.samples > 16 && truth.samples != 64) {
                    EXPECT_GT(reached, (1 - kAllowed) * mean_error) << id << ", seed " << seed;
                }
            }
        }
    }
}

TEST(TracingToAMeanError, IsThePictureOfSoManyRaysForAll) {
    const ReferenceScene reference(testing::thicket());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 120, 90);
    for (const double mean_error : {0.02, 0.004}) {
        const Truth truth = reference.trace(frame, kOneMetre, to_mean_error(mean_error), "mean");
        TruthSettings even;
        even.samples = truth.samples;
        const Truth same = reference.trace(frame, kOneMetre, even, "even");
        EXPECT_EQ(truth.visibility[0].pixels, same.visibility[0].pixels);
        EXPECT_EQ(truth.standard_error[0].pixels, same.standard_error[0].pixels);
        EXPECT_EQ(truth.sample_counts.pixels, same.sample_counts.pixels);
    }
}

TEST(TracingToAMeanError, HoldsForTheRadiusThatErrsMost) {
    const ReferenceScene reference(testing::thicket());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 120, 90);
    const std::vector<TruthQuery> radii = {{Falloff::binary, 0.1, 0}, {Falloff::binary, 3, 0}};
    constexpr double kMeanError = 0.01;
    const Truth truth = reference.trace(frame, radii, to_mean_error(kMeanError), "mean");
    double largest = 0;
    for (const ImageF& errors : truth.standard_error) {
        double sum = 0, surfaces = 0;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            if (truth.hits.surface.pixels[i] == 0) continue;
            sum += errors.pixels[i];
            ++surfaces;
        }
        largest = std::max(largest, sum / surfaces);
    }
    EXPECT_NEAR(largest, kMeanError, 0.045 * kMeanError);
}

/// Tiles of one surface each, whose errors fall as the rays to the power of -1/2.
TracePilot pilot_of(double error_of_one_ray, int& most_rays) {
    return [=, &most_rays](std::size_t tiles, int samples) {
        most_rays = std::max(most_rays, samples);
        const TileErrors each{.error_sums = {error_of_one_ray / std::sqrt(samples)}, .surfaces = 1};
        return PilotMeasure{.tiles = std::vector<TileErrors>(tiles, each)};
    };
}

/// Keeps groups in memory, and the search's likewise; after so many of both it is interrupted.
class Memory final : public TileStore {
  public:
    explicit Memory(int& keeps_left) : keeps_left_(keeps_left) {}
    bool has(std::size_t group) const override { return groups_.contains(group); }
    GroupState load(std::size_t group) const override { return groups_.at(group); }
    GroupState begun(std::size_t) const override { return {}; }
    void keep(std::size_t group, const GroupState& state) override {
        const std::scoped_lock lock(mutex_);
        groups_[group] = state;
        if (--keeps_left_ <= 0) throw interrupted_error();
    }
    TileStore* of_search() override {
        if (search_ == nullptr) search_ = std::make_unique<Memory>(keeps_left_);
        return search_.get();
    }

  private:
    int& keeps_left_;
    std::mutex mutex_;
    std::map<std::size_t, GroupState> groups_;
    std::unique_ptr<Memory> search_;
};

TEST(TracingToAnError, GoesOnWhereItWasInterruptedAndTracesNothingTwice) {
    const ReferenceScene reference(testing::thicket());
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 128, 96);
    set_thread_count(1);
    for (const TruthSettings& settings : {up_to(0.02), to_mean_error(0.01)}) {
        int plenty = std::numeric_limits<int>::max();
        Memory whole(plenty);
        const Truth undisturbed = reference.trace(frame, kOneMetre, settings, "undisturbed", &whole);
        const int keeps = std::numeric_limits<int>::max() - plenty;
        ASSERT_GT(keeps, 20);
        std::uint64_t last = undisturbed.rays_now;
        for (const int after : {1, keeps / 3, 2 * keeps / 3, keeps}) {
            int left = after;
            Memory store(left);
            EXPECT_THROW(reference.trace(frame, kOneMetre, settings, "interrupted", &store), Error);
            left = std::numeric_limits<int>::max();
            const Truth resumed = reference.trace(frame, kOneMetre, settings, "resumed", &store);
            EXPECT_EQ(std::numeric_limits<int>::max() - left, keeps - after)
                << "what was kept is not kept again";
            EXPECT_LE(resumed.rays_now, last) << "interrupted after " << after;
            EXPECT_EQ(resumed.visibility[0].pixels, undisturbed.visibility[0].pixels);
            EXPECT_EQ(resumed.standard_error[0].pixels, undisturbed.standard_error[0].pixels);
            last = resumed.rays_now;
        }
        EXPECT_EQ(last, 0u);
    }
    set_thread_count(0);
}

TEST(TracingToAMeanError, TracesHardlyMoreThanThePictureHas) {
    for (const char* id : {"atrium", "cathedral", "pillar", "railing"}) {
        const Scene scene = load_scene(id);
        const View& view = scene.views.front();
        const ReferenceScene reference(scene);
        const CameraFrame frame(view.camera, 320, 180);
        const std::vector<TruthQuery> query = {{Falloff::binary, view.radius_m.value_or(1), 0}};
        for (const double mean_error : {0.02, 0.01}) {
            const Truth truth = reference.trace(frame, query, to_mean_error(mean_error), "mean");
            // The few tiles of 920 that are tried with too many are traced again.
            EXPECT_LT(static_cast<double>(truth.rays_now), 1.16 * static_cast<double>(truth.rays)) << id;
        }
    }
}

/// A store that has nothing and is interrupted as soon as something is there to be kept.
class Started final : public TileStore {
  public:
    bool has(std::size_t) const override { return false; }
    GroupState load(std::size_t) const override { return {}; }
    GroupState begun(std::size_t) const override { return {}; }
    void keep(std::size_t, const GroupState&) override { throw interrupted_error(); }
};

ExitCode exit_code_at(const ReferenceScene& reference, const CameraFrame& frame,
                      const TruthSettings& settings, std::string& said) {
    Started store;
    try {
        reference.trace(frame, kOneMetre, settings, "", &store);
    } catch (const Error& e) {
        said = e.what();
        return e.exit_code();
    }
    return ExitCode::ok;
}

TEST(TracingToAnError, ThatNobodyCanReachIsSaidBeforeItStarts) {
    const ReferenceScene reference(testing::thicket());
    const Camera camera = testing::looking({2, 2, 3}, {0, 0.5, 0});
    for (const auto& [width, height] : {std::pair(640, 360), std::pair(3840, 2160)}) {
        const CameraFrame frame(camera, width, height);
        std::string said;
        for (const double error : {1e-6, 1e-7}) {
            for (const TruthSettings& settings : {up_to(error), to_mean_error(error)}) {
                EXPECT_EQ(exit_code_at(reference, frame, settings, said), ExitCode::usage) << said;
                EXPECT_NE(said.find("rays a pixel"), std::string::npos) << said;
                EXPECT_NE(said.find(" d (valid: "), std::string::npos) << said;
                EXPECT_NE(said.find("or more on this view"), std::string::npos) << said;
            }
        }
        EXPECT_EQ(exit_code_at(reference, frame, up_to(1e-9), said), ExitCode::usage);
        EXPECT_NE(said.find("below the rounding of float32"), std::string::npos) << said;
        EXPECT_EQ(exit_code_at(reference, frame, up_to(0.004), said), ExitCode::interrupted)
            << "what is in reach starts";
    }
}

TEST(SpreadTiles, AreAllTilesOnceAndItsFirstOnesLieEvenly) {
    for (const auto& [width, height] :
         {std::pair(640, 360), std::pair(100, 900), std::pair(64, 64), std::pair(5, 3)}) {
        const std::vector<SpreadTile> tiles = spread_tiles(width, height);
        std::set<std::pair<int, int>> corners;
        std::set<std::size_t> places;
        for (const SpreadTile& t : tiles) {
            corners.emplace(t.tile.x0, t.tile.y0);
            places.insert(t.place);
        }
        EXPECT_EQ(corners.size(), tiles_of(width, height).size());
        EXPECT_EQ(places.size(), tiles.size());
        std::vector<Tile> along(tiles.size());
        for (const SpreadTile& t : tiles) along[t.place] = t.tile;
        double farthest = 0;
        for (std::size_t i = 1; i < along.size(); ++i)
            farthest = std::max<double>(
                farthest, std::hypot(along[i].x0 - along[i - 1].x0, along[i].y0 - along[i - 1].y0));
        if (width == height) {
            EXPECT_EQ(farthest, kTileSide) << "neighbours on the curve are neighbours";
        }
        // Random ones would lie off by .29 over the root of their number.
        const auto middle = [&](std::size_t few) {
            double x = 0, y = 0;
            for (std::size_t i = 0; i < few; ++i) {
                x += static_cast<double>(tiles[i].tile.x0) / width / static_cast<double>(few);
                y += static_cast<double>(tiles[i].tile.y0) / height / static_cast<double>(few);
            }
            return std::pair(x, y);
        };
        const auto [x, y] = middle(tiles.size());
        for (std::size_t few = 64; few < tiles.size(); few *= 3) {
            EXPECT_NEAR(middle(few).first, x, 0.29 / std::sqrt(few)) << width << " " << few;
            EXPECT_NEAR(middle(few).second, y, 0.15 / std::sqrt(few)) << width << " " << few;
        }
    }
}

TEST(TracingToAMeanError, FindsTheRaysThatALawAsksFor) {
    int most_rays = 0;
    EXPECT_NEAR(rays_for_mean_error(0.01, 5000, 16, pilot_of(0.2, most_rays)).samples, 400, 16);
    EXPECT_LE(most_rays, 420) << "nothing is traced in vain";
    EXPECT_EQ(rays_for_mean_error(0.1, 5000, 16, pilot_of(0.2, most_rays)).samples, 16);
}

TEST(TracingToAMeanError, TellsHowManyItWillBeBeforeItTracesMuch) {
    int most_rays = 0, told = 0, traced_when_told = 0;
    const int samples =
        rays_for_mean_error(0.001, 5000, 16, pilot_of(0.2, most_rays), [&](const EvenRays& r) {
            told = r.samples;
            traced_when_told = most_rays;
        }).samples;
    EXPECT_NEAR(samples, 40000, 1600);
    EXPECT_NEAR(told, 40000, 1600);
    EXPECT_LE(traced_when_told, 4096);
}

TEST(TracingToAMeanError, SaysWhatIsOutOfReachBeforeItIsTraced) {
    int most_rays = 0;
    try {
        rays_for_mean_error(1e-4, 5000, 16, pilot_of(0.2, most_rays));
        FAIL() << "4,000,000 rays a pixel";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::usage);
        EXPECT_NE(std::string(e.what()).find("0.0001 takes about 4000000 rays a pixel"), std::string::npos)
            << e.what();
        EXPECT_NE(std::string(e.what()).find("valid: 0.00021 or more"), std::string::npos) << e.what();
    }
    EXPECT_LE(most_rays, 256);
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
