// Compares scores from few rays with those from a truth of 2 x 512 rays a pixel, on four scenes, and
// from 200 seeds with one of 4,096: the stated intervals hold the converged value as often as they say over
// scenes, images and seeds. Leaves coverage.md.
#include "metrics/analysis/mask_summary.h"
#include "metrics/analysis/occlusion_masks.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"
#include "store/truth/truth_cache.h"
#include "support/halved_scores.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {
namespace {

/// The first view of a scene, with a truth of any number of rays and the images of some methods.
class ScoredView {
  public:
    ScoredView(const std::string& scene, int width, int height, const std::vector<std::string>& methods)
        : scene_(load_scene(scene)), frame_{view_.camera, width, height} {
        const std::vector<MethodDescriptor> all = load_methods();
        renderer_.set_scene(scene_);
        for (const std::string& id : methods) {
            MethodRequest request;
            request.method = &find_method(all, id);
            request.parameters = request.method->values("default", {{"radius", radius_m_}});
            renderer_.draw_gbuffer(frame_, needed_gbuffer_inputs(request));
            images_[id] = renderer_.run(request).visibility;
            surface_ = renderer_.read_gbuffer().surface;
        }
    }

    const std::map<std::string, ImageF>& images() const { return images_; }

    Truth truth(int samples, std::uint64_t seed = 1) const {
        TruthRequest request{scene_.digest,
                             frame_.camera(),
                             surface_.width,
                             surface_.height,
                             {{Falloff::binary, radius_m_, 0}},
                             {},
                             {}};
        request.settings.samples = samples;
        request.settings.halves = true;
        request.settings.seed = seed;
        return trace_truth({}, reference_, request, {}, "few rays").truth;
    }

    Mask valid(const Truth& truth) const {
        Mask valid = surface_;
        for (std::size_t i = 0; i < valid.size(); ++i) valid.pixels[i] &= truth.hits.surface.pixels[i];
        return valid;
    }

    testing::HalvedScores measure(const Truth& truth, const ImageF& image) const {
        return testing::halved_scores(truth.visibility[0], truth.halves[0][0], truth.halves[0][1], image,
                                      valid(truth), truth.samples);
    }

  private:
    Scene scene_;
    View view_ = scene_.views.front();
    double radius_m_ = view_.radius_m.value_or(0.5);
    CameraFrame frame_;
    ReferenceScene reference_{scene_};
    ScreenRenderer renderer_;
    std::map<std::string, ImageF> images_;
    Mask surface_;
};

class ScoresFromFewRays : public ::testing::TestWithParam<const char*> {
  protected:
    testing::HalvedScores measure(int samples, std::uint64_t seed = 1) const {
        return view_.measure(view_.truth(samples, seed), view_.images().at("gtao"));
    }

  private:
    ScoredView view_{GetParam(), 320, 180, {"gtao"}};
};

/// How often, and how nearly, the stated interval of a metric from some number of rays held the converged
/// value.
struct Coverage {
    int seeds = 0, held = 0;
    double half_width = 0, error = 0;  ///< of the mean over the seeds
    double share() const { return static_cast<double>(held) / seeds; }
    void add(double error_now, double stated) {
        half_width = (half_width * seeds + stated) / (seeds + 1);
        error = (error * seeds + error_now) / (seeds + 1);
        held += std::abs(error_now) <= stated;
        ++seeds;
    }
};

TEST_P(ScoresFromFewRays, HoldTheConvergedOnesWithinWhatTheyState) {
    const testing::HalvedScores converged = measure(2 * 512);
    int checked = 0, held = 0;
    std::string table = fmt::format(
        "| {} | rays | intervals that hold it | mean half width | mean error |\n|---|---:|---:|---:|---:|\n",
        GetParam());
    for (const int samples : {16, 32, 64, 128}) {
        std::map<std::string, Coverage> by_metric;
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const testing::HalvedScores few = measure(samples, seed);
            for (const auto& [metric, half_width] : few.noise) {
                const double error = *few.values.at(metric).value - *converged.values.at(metric).value;
                const double stated = std::hypot(half_width, converged.noise.at(metric));
                by_metric[metric].add(error, stated);
                EXPECT_LE(std::abs(error), 3 * stated)
                    << metric << " from " << samples << " rays, seed " << seed << ", states " << half_width;
            }
        }
        for (const auto& [metric, coverage] : by_metric) {
            checked += coverage.seeds;
            held += coverage.held;
            table += fmt::format("| {} | {} | {} of {} | {:.2g} | {:+.2g} |\n", metric, samples,
                                 coverage.held, coverage.seeds, coverage.half_width, coverage.error);
        }
    }
    std::ofstream(testing::output_dir() / "coverage.md") << table;
    EXPECT_EQ(checked, 4 * 3 * 5);
    // One image of one scene, where what the extrapolation leaves is the same for all seeds: the share over
    // scenes and images is tested below.
    EXPECT_GE(held, 0.8 * checked) << held << " of " << checked << "\n" << table;
}

/// Adds the scores of a view from one seed after another, metric by metric, to `pooled` and to a table.
void cover(const std::string& scene, int rays, std::map<std::string, Coverage>& pooled, std::string& table) {
    constexpr int kSeeds = 200;
    const ScoredView view(scene, 160, 90, {"gtao", "hbao", "sao"});
    const Truth many = view.truth(4096, kSeeds + 1);
    std::map<std::string, std::map<std::string, Coverage>> by_method;
    std::map<std::string, testing::HalvedScores> converged;
    for (const auto& [method, image] : view.images()) converged[method] = view.measure(many, image);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Truth few = view.truth(rays, seed);
        for (const auto& [method, image] : view.images()) {
            const testing::HalvedScores scores = view.measure(few, image);
            for (const auto& [metric, half_width] : scores.noise) {
                const double error =
                    *scores.values.at(metric).value - *converged[method].values.at(metric).value;
                by_method[method][metric].add(error, half_width);
                pooled[metric].add(error, half_width);
            }
        }
    }
    for (const auto& [method, by_metric] : by_method) {
        for (const auto& [metric, coverage] : by_metric)
            table += fmt::format("| {}, {} | {} | {:.3f} | {:.2g} | {:+.2g} |\n", scene, method, metric,
                                 coverage.share(), coverage.half_width, coverage.error);
    }
}

// What the extrapolation leaves is the same for every seed, so that the share differs from scene to scene and
// from image to image: the statement is about all of them.
class IntervalsOverTwoHundredSeeds : public ::testing::TestWithParam<int> {};

TEST_P(IntervalsOverTwoHundredSeeds, HoldTheConvergedValueAsOftenAsTheySay) {
    std::map<std::string, Coverage> pooled;
    std::string table =
        "| view, method | metric | share of intervals that hold it | mean half width | mean error |\n"
        "|---|---|---:|---:|---:|\n";
    for (const char* scene : {"pillar", "railing"}) cover(scene, GetParam(), pooled, table);
    for (const auto& [metric, coverage] : pooled)
        table +=
            fmt::format("| all | {} | {:.3f} | {:.2g} | |\n", metric, coverage.share(), coverage.half_width);
    std::ofstream(testing::output_dir() / "coverage.md") << table;
    ASSERT_EQ(pooled.size(), 5U) << "all that are measured but MS-SSIM, which takes larger pictures";
    for (const auto& [metric, coverage] : pooled) {
        EXPECT_EQ(coverage.seeds, 2 * 3 * 200);
        EXPECT_GE(coverage.share(), 0.92) << metric << "\n" << table;
        EXPECT_LE(coverage.share(), 0.98) << metric << "\n" << table;
    }
}

constexpr double kThresholds[] = {0.05, 0.1, 0.2};

/// The areas of an image beyond some thresholds on both sides of the truth, with the half widths that they
/// state.
std::vector<MeasuredMask> areas_of(const ScoredView& view, const Truth& truth, const ImageF& image) {
    const Mask valid = view.valid(truth);
    const MetricInput input{truth.visibility[0], image, valid, &truth.standard_error[0]};
    std::vector<MeasuredMask> areas;
    for (const double threshold : kThresholds) {
        for (const MaskSide side : {MaskSide::missing, MaskSide::false_occlusion})
            areas.push_back(measure_mask(input, side, threshold));
    }
    return areas;
}

/// By threshold, of areas and of the mean errors over them. A mean is stated only where there surely is an
/// area.
struct MaskCoverage {
    std::map<double, Coverage> areas, means;
    int unstated_means = 0;
    void add(double threshold, const MeasuredMask& mask, const MaskSummary& converged) {
        areas[threshold].add(mask.summary.area - converged.area, mask.truth_noise.value());
        if (mask.mean_noise && converged.mean)
            means[threshold].add(*mask.summary.mean - *converged.mean, *mask.mean_noise);
        else
            ++unstated_means;
    }
};

std::string lines(const std::string& scene, const char* of, const std::map<double, Coverage>& by_threshold) {
    std::string text;
    for (const auto& [threshold, coverage] : by_threshold)
        text += fmt::format("| {}, {} | {} | {:.3f} | {:.2g} | {:+.2g} |\n", scene, of, threshold,
                            coverage.share(), coverage.half_width, coverage.error);
    return text;
}

/// What the masks of all images of a scene are from one seed after another, against those from 4,096 rays.
void cover_masks(const std::string& scene, int rays, MaskCoverage& pooled, std::string& table) {
    constexpr int kSeeds = 34;  // with six scenes, two hundred
    const ScoredView view(scene, 160, 90, {"gtao", "hbao", "sao", "xegtao", "n8ao", "crytek-ssao"});
    const Truth many = view.truth(4096, kSeeds + 1);
    MaskCoverage of_scene;
    std::vector<Truth> few;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) few.push_back(view.truth(rays, seed));
    for (const auto& [method, image] : view.images()) {
        const std::vector<MeasuredMask> converged = areas_of(view, many, image);
        for (const Truth& truth : few) {
            const std::vector<MeasuredMask> areas = areas_of(view, truth, image);
            for (std::size_t i = 0; i < areas.size(); ++i) {
                for (MaskCoverage* coverage : {&of_scene, &pooled})
                    coverage->add(kThresholds[i / 2], areas[i], converged[i].summary);
            }
        }
    }
    table += lines(scene, "areas", of_scene.areas) + lines(scene, "means", of_scene.means);
}

// What the boxes leave is the same for every seed, so that the statement is about scenes and images. The
// mean errors come from the same pixels, and the curve of the errors, from which percentiles are read, is 1
// less such areas.
class AreasOverSixScenes : public ::testing::TestWithParam<int> {};

TEST_P(AreasOverSixScenes, HoldTheConvergedOnesAsOftenAsTheySay) {
    MaskCoverage pooled;
    std::string table =
        "| view | threshold | share of intervals that hold it | mean half width | mean error |\n"
        "|---|---:|---:|---:|---:|\n";
    for (const char* scene : {"atrium", "cathedral", "courtyard", "pillar", "railing", "vault"})
        cover_masks(scene, GetParam(), pooled, table);
    table += lines("all", "areas", pooled.areas) + lines("all", "means", pooled.means);
    std::ofstream(testing::output_dir() / "coverage.md") << table;
    constexpr int kMasks = 6 * 6 * 34 * 2;
    for (const auto& [threshold, coverage] : pooled.areas) {
        EXPECT_EQ(coverage.seeds, kMasks);
        EXPECT_GE(coverage.share(), threshold == kMaskThreshold ? 0.92 : 0.90) << threshold << "\n" << table;
        EXPECT_LE(coverage.share(), 0.98) << threshold << "\n" << table;
    }
    EXPECT_LT(pooled.unstated_means, 0.15 * 3 * kMasks);
    for (const auto& [threshold, coverage] : pooled.means) {
        EXPECT_GE(coverage.share(), threshold == kMaskThreshold ? 0.92 : 0.85) << threshold << "\n" << table;
        EXPECT_LE(coverage.share(), 0.98) << threshold << "\n" << table;
    }
}

INSTANTIATE_TEST_SUITE_P(Rays, AreasOverSixScenes, ::testing::Values(16, 32, 64),
                         ::testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Rays, IntervalsOverTwoHundredSeeds, ::testing::Values(16, 32),
                         ::testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Scenes, ScoresFromFewRays, ::testing::Values("atrium", "yard", "pillar", "sphere"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace aoscore
