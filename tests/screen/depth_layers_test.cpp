// Tests the depth layers of a texel: the law by which a sample captures a surface, and inputs that must not
// change a bit.
#include "hand_made.h"
#include "screen/gbuffer/depth_layer_buffer.h"
#include "screen/gl/context.h"
#include "screen/method/layer_bytes.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <set>

namespace aoscore::testing {
namespace {

constexpr int kSide = 160, kWalls = 5;

DepthLayers layers_of(const std::string& sampling, int samples, double alpha, std::uint32_t seed = 1) {
    return {.samples = samples, .alpha = alpha, .sampling = sampling, .seed = seed};
}

std::vector<std::string> random_samplings() {
    std::vector<std::string> ids;
    for (const DepthSampling& sampling : depth_samplings()) {
        if (sampling.tosses_coins) ids.emplace_back(sampling.id);
    }
    return ids;
}

bool is_anchored(const std::string& sampling) {
    return sampling == "isotropic" || sampling == "anisotropic";
}

/// Walls that fill the picture, one behind the other, turned a little so that no axis of the scene is the
/// picture's.
Scene walls() {
    Scene scene = empty_scene();
    for (int i = 0; i < kWalls; ++i) add_quad(scene, {-40, -40, -16.0 - i}, {80, 0, 10}, {0, 80, 6});
    return scene;
}

/// The numbers of a texel's samples that hold each wall, and of those that hold none.
struct Held {
    std::array<int, kWalls> by_wall{};
    int empty = 0;
};

class Walls : public ::testing::Test {
  protected:
    Walls() {
        renderer_.set_scene(walls());
        renderer_.draw_gbuffer(CameraFrame(front_camera(), kSide, kSide), {});
        renderer_.draw_depth_layers({.samples = kWalls, .sampling = "peeled"});
        peeled_ = renderer_.read_depth_layers();
    }

    /// Counts in texels far enough apart to have independent coins, where the noise lies in voxels of about a
    /// pixel.
    std::vector<Held> held(const DepthLayers& layers) {
        renderer_.draw_depth_layers(layers);
        const std::vector<ImageF> samples = renderer_.read_depth_layers();
        std::vector<Held> all;
        const int stride = is_anchored(layers.sampling) ? 4 : 1;
        for (int y = 0; y < kSide; y += stride) {
            for (int x = 0; x < kSide; x += stride) all.push_back(held_at(samples, x, y));
        }
        return all;
    }

    ScreenRenderer renderer_;
    std::vector<ImageF> peeled_;

  private:
    Held held_at(const std::vector<ImageF>& samples, int x, int y) const {
        Held held;
        for (const ImageF& sample : samples) {
            const auto wall = std::ranges::find_if(
                peeled_, [&](const ImageF& layer) { return layer.at(x, y) == sample.at(x, y); });
            if (wall != peeled_.end()) {
                ++held.by_wall[static_cast<std::size_t>(wall - peeled_.begin())];
            } else {
                EXPECT_EQ(sample.at(x, y), 100.0F) << "neither a wall nor the far plane";
                ++held.empty;
            }
        }
        return held;
    }
};

double choose(int n, int k) {
    if (k < 0 || k > n) return 0;
    double product = 1;
    for (int i = 0; i < k; ++i) product = product * (n - i) / (i + 1);
    return product;
}

/// The probability that some sample of S captures the wall behind `before` others, with independent samples.
double captured_by_coins(double alpha, int samples, int before) {
    return 1 - std::pow(1 - alpha * std::pow(1 - alpha, before), samples);
}

/// The probability where a wall takes R of the S samples, R being alpha S rounded up or down, by the number
/// of samples that no nearer wall has taken.
double captured_by_strata(double alpha, int samples, int before) {
    const int low = static_cast<int>(std::floor(alpha * samples + 1e-9));
    const double up = alpha * samples - low;
    std::vector<double> free(static_cast<std::size_t>(samples) + 1, 0.0);  // distribution
    free.back() = 1;
    for (int wall = 0;; ++wall) {
        double captured = 0;
        std::vector<double> next(free.size(), 0.0);
        for (int f = 0; f <= samples; ++f) {
            for (const auto& [taken, chance] : {std::pair(low, 1 - up), std::pair(low + 1, up)}) {
                if (chance <= 0) continue;
                for (int hit = 0; hit <= std::min(f, taken); ++hit) {
                    const double p = free[static_cast<std::size_t>(f)] * chance * choose(f, hit) *
                                     choose(samples - f, taken - hit) / choose(samples, taken);
                    next[static_cast<std::size_t>(f - hit)] += p;
                    captured += hit > 0 ? p : 0;
                }
            }
        }
        if (wall == before) return captured;
        free = std::move(next);
    }
}

/// Five standard errors of a share, for so many independent texels.
double five_errors(double share, std::size_t count) {
    return 5 * std::sqrt(std::max(share * (1 - share), 1e-4) / static_cast<double>(count));
}

TEST_F(Walls, AreCapturedByTheLawOfTheSampling) {
    for (const std::string& sampling : random_samplings()) {
        for (const double alpha : {0.2, 0.05, 0.7}) {
            for (const int samples : {1, 2, 3, 4, 5, 6, 8, 16}) {
                const std::vector<Held> all = held(layers_of(sampling, samples, alpha));
                for (int wall = 0; wall < kWalls; ++wall) {
                    const auto captured = std::ranges::count_if(
                        all, [&](const Held& h) { return h.by_wall[static_cast<std::size_t>(wall)] > 0; });
                    const double share = static_cast<double>(captured) / static_cast<double>(all.size());
                    const double expected = sampling == "stratified"
                                                ? captured_by_strata(alpha, samples, wall)
                                                : captured_by_coins(alpha, samples, wall);
                    EXPECT_NEAR(share, expected, five_errors(expected, all.size()))
                        << sampling << ", alpha " << alpha << ", S " << samples << ", wall " << wall + 1;
                }
            }
        }
    }
}

TEST_F(Walls, OfTheFrontAreAlwaysCapturedFromAlphaTimesSamplesOfOneOn) {
    EXPECT_NEAR(captured_by_strata(0.2, 4, 0), 0.8, 1e-12);
    EXPECT_NEAR(captured_by_coins(0.2, 4, 0), 0.5904, 1e-12);
    for (const Held& h : held(layers_of("stratified", 8, 0.2))) {
        ASSERT_GE(h.by_wall[0], 1);
        ASSERT_LE(h.by_wall[0], 2);
    }
}

TEST_F(Walls, LeaveAsManySamplesEmptyAsPassThemAll) {
    for (const std::string& sampling : random_samplings()) {
        const std::vector<Held> all = held(layers_of(sampling, 8, 0.2));
        double empty = 0;
        for (const Held& h : all) empty += h.empty / 8.0;
        const double expected = std::pow(0.8, kWalls), share = empty / static_cast<double>(all.size());
        EXPECT_NEAR(share, expected, five_errors(expected, all.size())) << sampling;
    }
}

// A stratum's size takes two neighbouring values; a sum of coins is binomial.
TEST_F(Walls, AreHeldByNumbersOfSamplesWhoseVarianceIsTheSamplings) {
    const double alpha = 0.2;
    for (const std::string& sampling : random_samplings()) {
        for (const int samples : {1, 4, 16}) {
            const std::vector<Held> all = held(layers_of(sampling, samples, alpha));
            double sum = 0, squares = 0;
            for (const Held& h : all) {
                sum += h.by_wall[0];
                squares += h.by_wall[0] * h.by_wall[0];
            }
            const auto count = static_cast<double>(all.size());
            const double mean = sum / count, variance = squares / count - mean * mean;
            const double part = alpha * samples - std::floor(alpha * samples);
            const double expected =
                sampling == "stratified" ? part * (1 - part) : samples * alpha * (1 - alpha);
            EXPECT_NEAR(mean, alpha * samples, 5 * std::sqrt(expected / count)) << sampling;
            EXPECT_NEAR(variance, expected, 10 * expected / std::sqrt(count)) << sampling << " " << samples;
        }
    }
}

TEST_F(Walls, HaveOneCoinForAllSamplesWhereTheSamplesShareIt) {
    for (const std::string& sampling : random_samplings()) {
        if (sampling == "stratified") continue;
        DepthLayers layers = layers_of(sampling, 8, 0.2);
        layers.per_sample = false;
        const std::vector<Held> all = held(layers);
        std::size_t captured = 0;
        for (const Held& h : all) {
            ASSERT_TRUE(h.by_wall[0] == 0 || h.by_wall[0] == 8) << sampling;
            captured += h.by_wall[0] > 0 ? 1 : 0;
        }
        EXPECT_NEAR(static_cast<double>(captured) / static_cast<double>(all.size()), 0.2,
                    five_errors(0.2, all.size()))
            << sampling;
    }
}

// Two seeds share no coins, nor do neighbouring samples of neighbouring seeds.
TEST_F(Walls, HaveCoinsThatNoOtherSeedHas) {
    for (const std::string& sampling : random_samplings()) {
        renderer_.draw_depth_layers(layers_of(sampling, 2, 0.5, 2));
        const std::vector<ImageF> a = renderer_.read_depth_layers();
        renderer_.draw_depth_layers(layers_of(sampling, 2, 0.5, 3));
        const std::vector<ImageF> b = renderer_.read_depth_layers();
        std::size_t same = 0, crossed = 0;
        for (std::size_t i = 0; i < a[0].size(); ++i) {
            same += a[0].pixels[i] == b[0].pixels[i] ? 1 : 0;
            crossed += a[0].pixels[i] == b[1].pixels[i] ? 1 : 0;
        }
        // Both hold wall j with probability 4^-j, or both are empty.
        const double expected = (1 - std::pow(0.25, kWalls)) / 3 + std::pow(0.25, kWalls);
        const double count = static_cast<double>(a[0].size()), error = is_anchored(sampling) ? 0.04 : 0.016;
        EXPECT_NEAR(static_cast<double>(same) / count, expected, error) << sampling;
        EXPECT_NEAR(static_cast<double>(crossed) / count, expected, error) << sampling;
    }
}

/// A view of a built-in scene with cut-outs, and the corner, in both projections.
struct Stage {
    std::string name;
    Scene scene;
    CameraFrame frame;
};

std::vector<Stage> stages() {
    const Scene atrium = load_scene("atrium");
    Camera parallel = corner_camera();
    parallel.projection = Camera::Projection::orthographic;
    parallel.half_height = 1.7;
    return {{"atrium", atrium, CameraFrame(find_view(atrium, "wide").camera, 160, 90)},
            {"corner", corner_scene(), CameraFrame(corner_camera(), 161, 97)},
            {"parallel corner", corner_scene(), CameraFrame(parallel, 97, 61)}};
}

TEST(DepthLayers, AreTheFirstLayerBitForBitWhereEverySurfaceIsKept) {
    for (const Stage& stage : stages()) {
        ScreenRenderer renderer;
        renderer.set_scene(stage.scene);
        renderer.draw_gbuffer(stage.frame, {});
        const ImageF first = renderer.read_gbuffer().linear_depth();
        for (const DepthSampling& sampling : depth_samplings()) {
            if (!is_rasterised(sampling.id)) continue;
            for (const int samples : {1, 2, 3, 8, 16}) {
                renderer.draw_depth_layers(layers_of(std::string(sampling.id), samples, 1));
                const std::vector<ImageF> layers = renderer.read_depth_layers();
                ASSERT_EQ(layers.size(), static_cast<std::size_t>(samples));
                EXPECT_EQ(layers.front().pixels, first.pixels) << stage.name << " " << sampling.id;
                if (!sampling.tosses_coins) continue;
                for (const ImageF& layer : layers)
                    ASSERT_EQ(layer.pixels, first.pixels) << stage.name << " " << sampling.id << samples;
            }
        }
    }
}

// Some walls move: the nearest of these, and the nearest of the others, wherever they stand.
TEST_F(Walls, ThatStandStillAndThatMoveHaveALayerEach) {
    constexpr float kFar = 100;
    for (const std::set<std::size_t>& moving : std::vector<std::set<std::size_t>>{
             {}, {0}, {1, 3}, {0, 1, 4}, {4}, {0, 1, 2, 3, 4}}) {
        Scene scene = walls();
        for (const std::size_t wall : moving) scene.instances[wall].is_dynamic = true;
        renderer_.set_scene(scene);
        renderer_.draw_gbuffer(CameraFrame(front_camera(), kSide, kSide), {});
        renderer_.draw_depth_layers({.samples = 2, .sampling = "static_and_dynamic"});
        const std::vector<ImageF> layers = renderer_.read_depth_layers();
        ASSERT_EQ(layers.size(), 2U);
        for (const bool moves : {false, true}) {
            std::size_t nearest = 0;
            while (nearest < kWalls && moving.contains(nearest) != moves) ++nearest;
            const ImageF& layer = layers[moves ? 1 : 0];
            if (nearest < kWalls) {
                EXPECT_EQ(layer.pixels, peeled_[nearest].pixels) << moves << " " << nearest;
            } else {
                EXPECT_TRUE(std::ranges::all_of(layer.pixels, [](float z) { return z == kFar; })) << moves;
            }
        }
    }
}

TEST(DepthLayers, ArePeeledAsTheGBuffersLayersAre) {
    for (const Stage& stage : stages()) {
        ScreenRenderer renderer;
        renderer.set_scene(stage.scene);
        Capture capture(stage.frame, {});
        capture.layers = 6;
        renderer.draw_gbuffer(capture);
        renderer.draw_depth_layers({.samples = 6, .sampling = "peeled"});
        const std::vector<ImageF> peeled = renderer.read_depth_layers();
        for (int layer = 0; layer < 6; ++layer) {
            EXPECT_EQ(peeled[static_cast<std::size_t>(layer)].pixels,
                      renderer.read_gbuffer({.layer = layer}).linear_depth().pixels)
                << stage.name << " " << layer;
        }
    }
}

// The nearest layer, and behind each the nearest that lies at least the gap farther, found among all of them.
TEST(DepthLayers, KeepTheirLeastGap) {
    for (const Stage& stage : stages()) {
        ScreenRenderer renderer;
        renderer.set_scene(stage.scene);
        renderer.draw_gbuffer(stage.frame, {});
        const float far = static_cast<float>(stage.frame.camera().far);
        renderer.draw_depth_layers({.samples = 16, .sampling = "peeled"});
        const std::vector<ImageF> all = renderer.read_depth_layers();
        const double gap = 0.03 * static_cast<double>(far);
        renderer.draw_depth_layers({.samples = 3, .sampling = "peeled", .least_gap_m = gap});
        const std::vector<ImageF> apart = renderer.read_depth_layers();
        std::size_t behind = 0, wrong = 0;
        for (std::size_t i = 0; i < all[0].size(); ++i) {
            double before = -1e9;
            for (const ImageF& layer : apart) {
                float expected = far;
                for (const ImageF& candidate : all) {
                    // A surface within rounding of the gap may stand on either side of it.
                    if (static_cast<double>(candidate.pixels[i]) >= before + gap * (1 - 1e-4))
                        expected = std::min(expected, candidate.pixels[i]);
                }
                wrong += layer.pixels[i] != expected ? 1 : 0;
                behind += layer.pixels[i] != far && before > 0 ? 1 : 0;
                before = static_cast<double>(layer.pixels[i]);
            }
        }
        EXPECT_LE(wrong, all[0].size() / 1000) << stage.name;
        EXPECT_GT(behind, all[0].size() / 100) << stage.name;
    }
}

// Layers hold both sides of every wall, and surfaces seen through the holes of cut-outs.
TEST(DepthLayers, HoldNothingButSurfacesOfTheirTexel) {
    for (const Stage& stage : stages()) {
        ScreenRenderer renderer;
        renderer.set_scene(stage.scene);
        renderer.draw_gbuffer(stage.frame, {});
        const float far = static_cast<float>(stage.frame.camera().far);
        renderer.draw_depth_layers({.samples = 16, .sampling = "peeled"});
        const std::vector<ImageF> peeled = renderer.read_depth_layers();
        renderer.draw_depth_layers(layers_of("stratified", 4, 0.3));
        const std::vector<ImageF> samples = renderer.read_depth_layers();
        std::size_t deeper = 0, not_peeled = 0;
        for (std::size_t i = 0; i < peeled[0].size(); ++i) {
            const bool all_peeled = peeled.back().pixels[i] == far;
            for (const ImageF& sample : samples) {
                const float depth = sample.pixels[i];
                const bool known = depth == far || std::ranges::any_of(peeled, [&](const ImageF& layer) {
                                       return layer.pixels[i] == depth;
                                   });
                // Peeling drops all but one of the surfaces that share a window depth.
                not_peeled += all_peeled && !known ? 1 : 0;
                deeper += known && depth != far && depth != peeled[0].pixels[i] ? 1 : 0;
            }
        }
        EXPECT_LE(not_peeled, peeled[0].size() / 500) << stage.name;
        EXPECT_GT(deeper, peeled[0].size() / 40) << stage.name;
    }
}

/// Jarzynski and Olano, Hash Functions for GPU Rendering, 2020, for a first lane alone.
std::uint32_t first_lane_of_pcg4d(std::array<std::uint32_t, 4> v) {
    for (std::uint32_t& lane : v) lane = lane * 1664525U + 1013904223U;
    const auto mix = [&v] {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
    };
    mix();
    for (std::uint32_t& lane : v) lane ^= lane >> 16U;
    mix();
    return v[0];
}

// What is kept for programs without the scene is enough to gather the layers anew: here by one coin a
// surface, tossed for the numbers of pixel and triangle.
TEST(KeptSurfaces, AreThePeeledLayersAndTossTheSameCoins) {
    constexpr double kAlpha = 0.25;
    constexpr std::uint32_t kSeed = 7;
    for (const Stage& stage : stages()) {
        ScreenRenderer renderer;
        renderer.set_scene(stage.scene);
        renderer.draw_gbuffer(stage.frame, {});
        const std::vector<SurfaceLayer> surfaces = renderer.read_surfaces();
        renderer.draw_depth_layers({.samples = 16, .sampling = "peeled", .facing = true});
        const std::vector<ImageF> peeled = renderer.read_depth_layers();
        ASSERT_LE(surfaces.size(), peeled.size()) << stage.name;
        ASSERT_GE(surfaces.size(), 2U) << stage.name;
        for (std::size_t k = 0; k < surfaces.size(); ++k)
            EXPECT_EQ(surfaces[k].depth_m.pixels, peeled[k].pixels) << stage.name << " " << k;
        renderer.draw_depth_layers(layers_of("simple_hash", 1, kAlpha, kSeed));
        const ImageF sample = renderer.read_depth_layers().front();
        const auto far = static_cast<float>(stage.frame.camera().far);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < sample.size(); ++i) {
            float nearest = far;
            for (const SurfaceLayer& surface : surfaces) {
                const float depth = std::abs(surface.depth_m.pixels[i]);
                const std::uint32_t triangle = static_cast<std::uint32_t>(surface.triangle_low.pixels[i]) |
                                               static_cast<std::uint32_t>(surface.triangle_high.pixels[i])
                                                   << 16U;
                const auto x = static_cast<std::uint32_t>(i % static_cast<std::size_t>(sample.width));
                const auto y = static_cast<std::uint32_t>(i / static_cast<std::size_t>(sample.width));
                const std::uint32_t bits = first_lane_of_pcg4d({x, y, triangle, kSeed * 2654435769U});
                if ((bits >> 16U) / 65536.0 < kAlpha) nearest = std::min(nearest, depth);
            }
            wrong += nearest != sample.pixels[i] ? 1 : 0;
        }
        EXPECT_LE(wrong, sample.size() / 500) << stage.name << ": surfaces that share a window depth";
    }
}

// A closed form: a texel holds one, two, or whole fours of floats.
TEST(LayerBytes, AreFourASampleInWholeTexelsAndAPictureForEachCamera) {
    const std::vector<MethodDescriptor> methods = load_methods();
    const auto bytes = [&](const char* method, const ParameterValues& settings, double band_px = 0) {
        MethodRequest request;
        request.method = &find_method(methods, method);
        request.parameters = request.method->values("default", settings);
        request.guard_band.width = band_px;
        return layer_bytes(request, 1920, 1080);
    };
    constexpr std::size_t kPixels = 1920 * 1080;
    EXPECT_EQ(bytes("sd-ssao", {{"depth_samples", 1}}), 4 * kPixels);
    EXPECT_EQ(bytes("sd-ssao", {{"depth_samples", 2}}), 8 * kPixels);
    EXPECT_EQ(bytes("sd-ssao", {{"depth_samples", 5}}), 32 * kPixels);
    EXPECT_EQ(bytes("sd-ssao", {{"depth_samples", 16}}), 132'710'400U) << "below 160 MB";
    EXPECT_EQ(bytes("sd-ssao", {{"depth_samples", 1}}, 8), 4U * 1936 * 1096);
    EXPECT_EQ(bytes("sd-hbao-plus", {{"depth_samples", 4}, {"side_cameras", 2}, {"side_scale", 2}}),
              16 * kPixels + 2 * 16 * kPixels / 4);
    EXPECT_EQ(bytes("hbao", {}), std::nullopt);
}

TEST(DepthLayers, DoNotDependOnTheOrderOfDrawing) {
    for (const Stage& stage : stages()) {
        const std::unique_ptr<GlContext> context = new_gl_context();
        const SceneGeometry geometry(stage.scene);
        std::vector<SceneGeometry::Draw> reversed = geometry.draws();
        ASSERT_GT(reversed.size(), 4U);
        std::ranges::reverse(reversed);
        DepthLayerBuffer buffer;
        for (const std::string& sampling : random_samplings()) {
            const DepthLayers layers = layers_of(sampling, 8, 0.2);
            buffer.draw(geometry, {layers, {stage.frame}}, geometry.draws());
            const std::vector<ImageF> forward = buffer.read();
            buffer.draw(geometry, {layers, {stage.frame}}, reversed);
            const std::vector<ImageF> backward = buffer.read();
            for (std::size_t i = 0; i < forward.size(); ++i)
                EXPECT_EQ(forward[i].pixels, backward[i].pixels) << stage.name << " " << sampling;
        }
    }
}

}  // namespace
}  // namespace aoscore::testing
