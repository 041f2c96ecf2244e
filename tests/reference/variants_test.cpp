// A scene gives the same truth when it is written in other ways.
#include "reference/truth.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace aoscore {
namespace {

constexpr int kWidth = 72, kHeight = 48, kSamples = 32;

Scene load(const std::string& file) {
    return load_scene((testing::shared_dir() / "scenes" / file).string());
}

const Camera& own_camera(const Scene& scene) {
    const auto found = std::find_if(scene.views.begin(), scene.views.end(),
                                    [](const View& view) { return view.kind == View::Kind::node; });
    if (found == scene.views.end()) throw std::runtime_error(scene.id + " has no camera of its own");
    return found->camera;
}

Truth truth_of(const Scene& scene) {
    TruthSettings settings;
    settings.samples = kSamples;
    const std::vector<TruthQuery> query = {{Falloff::binary, scene.bounds.diagonal() / 50, 0}};
    return ReferenceScene(scene).trace(CameraFrame(own_camera(scene), kWidth, kHeight), query, settings,
                                       "test");
}

/// The comparison of two pictures, over pixels that see a surface in both, at one depth to 1 %, which leaves
/// out edges.
struct Comparison {
    int common = 0, all = 0;
    double mean_difference = 0;
    double excess = 0;  ///< mean squared difference beyond the noise of both
    double noise = 0;   ///< standard error of mean_difference, samples taken as independent
};

Comparison compare(const Truth& a, const Truth& b, bool mirrored) {
    Comparison c;
    double variance = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int other = mirrored ? kWidth - 1 - x : x;
            c.all += a.hits.surface.at(x, y) != 0 || b.hits.surface.at(other, y) != 0 ? 1 : 0;
            const float depth_a = a.hits.depth.at(x, y), depth_b = b.hits.depth.at(other, y);
            if (!(depth_a > 0) || !(std::abs(depth_a - depth_b) <= 0.01f * depth_a)) continue;
            ++c.common;
            const double difference = a.visibility[0].at(x, y) - b.visibility[0].at(other, y);
            const double se_a = a.standard_error[0].at(x, y), se_b = b.standard_error[0].at(other, y);
            c.mean_difference += difference;
            c.excess += difference * difference - se_a * se_a - se_b * se_b;
            variance += se_a * se_a + se_b * se_b;
        }
    }
    c.mean_difference /= c.common;
    c.excess /= c.common;
    c.noise = std::sqrt(variance) / c.common;
    return c;
}

struct Variant {
    const char* file;
    const char* original;
    bool mirrored = false;
    /// Tolerance of the mean beyond noise: quantisation moves edges of shadows.
    double tolerance = 0.002;
};

TEST(Variants, GiveTheTruthOfTheirOriginalWithinNoise) {
    REQUIRE_SHARED_INPUTS();
    for (const Variant& v : {Variant{"variants/stanford_group.quantized.glb", "stanford_group.glb"},
                             {"variants/stanford_group.mirror.glb", "stanford_group.glb", true},
                             {"variants/sponza_crytek.quantized.glb", "sponza_crytek.glb"},
                             {"variants/staircase.zup.glb", "staircase.glb"},
                             {"variants/sibenik.draco.glb", "sibenik.glb"},
                             {"variants/fireplace_room.gltfpack_instanced.glb", "fireplace_room.glb"},
                             {"variants/cornell_original.tiny_1e-4.glb", "cornell_original.glb"}}) {
        const Scene original = load(v.original), variant = load(v.file);
        const double scale = original.bounds.diagonal() / variant.bounds.diagonal();
        Truth a = truth_of(original), b = truth_of(variant);
        for (float& depth : b.hits.depth.pixels) depth *= static_cast<float>(scale);
        const Comparison c = compare(a, b, v.mirrored);
        EXPECT_GT(c.common, 0.95 * c.all) << v.file;
        EXPECT_LE(std::abs(c.mean_difference), 4 * c.noise + v.tolerance) << v.file;
        EXPECT_LE(c.excess, 0.02 * 0.02) << v.file;
    }
}

}  // namespace
}  // namespace aoscore
