// Compares stated errors with true ones, pixel by pixel and in the tail, on six scenes; writes
// calibration.md.
#include "reference/test_scenes.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

namespace aoscore {
namespace {

constexpr int kWidth = 56, kHeight = 32;
constexpr int kExactSamples = 4096;

struct Case {
    std::string name;
    Scene scene;
    Camera camera;
    double radius_m;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const auto& [id, view, radius_m] : {std::tuple{"atrium", "wide", 0.5},
                                             {"atrium", "close", 1.0},
                                             {"cathedral", "nave", 1.0},
                                             {"yard", "front", 1.0}}) {
        Scene scene = load_scene(id);
        const Camera camera = find_view(scene, view).camera;
        list.push_back({fmt::format("{}/{}", id, view), std::move(scene), camera, radius_m});
    }
    list.push_back({"still life", testing::still_life(), testing::looking({2, 2, 3}, {0, 0.5, 0}), INFINITY});
    list.push_back({"thicket", testing::thicket(), testing::looking({2, 2, 3}, {0, 0.5, 0}), 1});
    return list;
}

struct Calibration {
    double squared = 0, stated = 0, pixels = 0, beyond = 0;
    double ratio() const { return std::sqrt(squared / stated); }
    double share_beyond() const { return beyond / pixels; }
    void add(const Calibration& other) {
        squared += other.squared;
        stated += other.stated;
        pixels += other.pixels;
        beyond += other.beyond;
    }
    /// Adds the truth's pixels that needed rays; the stated errors include that of `exact`.
    void add(const Truth& truth, const Truth& exact) {
        for (std::size_t i = 0; i < truth.sample_counts.size(); ++i) {
            if (truth.sample_counts.pixels[i] == 0) continue;
            const double error = truth.visibility[0].pixels[i] - exact.visibility[0].pixels[i];
            const double variance = std::pow(truth.standard_error[0].pixels[i], 2) +
                                    std::pow(exact.standard_error[0].pixels[i], 2);
            squared += error * error;
            stated += variance;
            ++pixels;
            beyond += error * error > 9 * variance;
        }
    }
};

std::string row(const std::string& name, int samples, const Calibration& c) {
    return fmt::format("| {} | {} | {:.3f} | {:.3f} |\n", name, samples, c.ratio(), 100 * c.share_beyond());
}

// A scene's distribution of errors may differ from the usual one: the yard of a few large boxes has the
// fewest, the thicket of blades the most.
TEST(StandardErrors, HoldInTheTailAtFewRays) {
    constexpr std::array kSamples = {16, 64, 256};
    std::array<Calibration, kSamples.size()> all;
    std::string table =
        "| scene | rays | true / stated (rms) | beyond 3 stated errors, % |\n|---|---|---|---|\n";
    for (const Case& c : cases()) {
        const ReferenceScene reference(c.scene);
        const CameraFrame frame(c.camera, kWidth, kHeight);
        const std::vector<TruthQuery> query = {{Falloff::binary, c.radius_m, 0}};
        TruthSettings settings;
        settings.samples = kExactSamples;
        settings.seed = 999;
        const Truth exact = reference.trace(frame, query, settings, "exact");
        for (std::size_t n = 0; n < kSamples.size(); ++n) {
            settings.samples = kSamples[n];
            Calibration calibration;
            const std::uint64_t seeds = kSamples[n] < 256 ? 16 : 8;
            for (settings.seed = 1; settings.seed <= seeds; ++settings.seed)
                calibration.add(reference.trace(frame, query, settings, "calibration"), exact);
            table += row(c.name, kSamples[n], calibration);
            all[n].add(calibration);
            // Errors are drawn towards the usual law, so that a scene may state a fifth too much, but hardly
            // too little.
            EXPECT_GT(calibration.ratio(), 0.77) << c.name << ", " << kSamples[n] << " rays";
            EXPECT_LT(calibration.ratio(), 1.1) << c.name << ", " << kSamples[n] << " rays";
            EXPECT_LT(calibration.share_beyond(), 0.014) << c.name << ", " << kSamples[n] << " rays";
        }
    }
    for (std::size_t n = 0; n < kSamples.size(); ++n) {
        table += row("all", kSamples[n], all[n]);
        EXPECT_NEAR(all[n].ratio(), 1, 0.05) << kSamples[n] << " rays";
        EXPECT_LT(all[n].share_beyond(), 0.005) << kSamples[n] << " rays";
    }
    std::ofstream(testing::output_dir() / "calibration.md") << table;
}

}  // namespace
}  // namespace aoscore
