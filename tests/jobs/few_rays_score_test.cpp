// Compares scores from few rays with those from a truth of 2 x 512 rays a pixel, on four scenes: whatever the
// noise, the converged value lies within the stated interval. Leaves coverage.md.
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

namespace aoscore {
namespace {

constexpr int kWidth = 320, kHeight = 180;

class ScoresFromFewRays : public ::testing::TestWithParam<const char*> {
  protected:
    ScoresFromFewRays() {
        const std::vector<MethodDescriptor> methods = load_methods();
        MethodRequest request;
        request.method = &find_method(methods, "gtao");
        request.parameters = request.method->values("default", {{"radius", radius_m_}});
        renderer_.set_scene(scene_);
        renderer_.draw_gbuffer(frame_, needed_gbuffer_inputs(request));
        image_ = renderer_.run(request).visibility;
        surface_ = renderer_.read_gbuffer().surface;
    }

    testing::HalvedScores measure(int samples, std::uint64_t seed = 1) const {
        TruthRequest request{
            scene_.digest, frame_.camera(), kWidth, kHeight, {{Falloff::binary, radius_m_, 0}}, {}, {}};
        request.settings.samples = samples;
        request.settings.halves = true;
        request.settings.seed = seed;
        const Truth truth = trace_truth({}, reference_, request, {}, "few rays").truth;
        Mask valid = surface_;
        for (std::size_t i = 0; i < valid.size(); ++i) valid.pixels[i] &= truth.hits.surface.pixels[i];
        return testing::halved_scores(truth.visibility[0], truth.halves[0][0], truth.halves[0][1], image_,
                                      valid);
    }

  private:
    Scene scene_ = load_scene(GetParam());
    View view_ = scene_.views.front();
    double radius_m_ = view_.radius_m.value_or(0.5);
    CameraFrame frame_{view_.camera, kWidth, kHeight};
    ReferenceScene reference_{scene_};
    ScreenRenderer renderer_;
    ImageF image_;
    Mask surface_;
};

/// How often, and how nearly, the stated interval of a metric from some number of rays held the converged
/// value.
struct Coverage {
    int seeds = 0, held = 0;
    double half_width = 0, error = 0;  ///< of the mean over the seeds
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
                EXPECT_LE(std::abs(error), 2 * stated)
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
    EXPECT_GE(held, 0.9 * checked) << held << " of " << checked << "\n" << table;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ScoresFromFewRays, ::testing::Values("atrium", "yard", "pillar", "sphere"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace aoscore
