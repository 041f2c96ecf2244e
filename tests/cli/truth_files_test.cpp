// Tests the contents of truth files and results beside visibility.
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

namespace aoscore {
namespace {

using testing::output_dir;
using testing::run_aoscore;

/// The largest difference between the sum of a truth file's causes and 1 - `visibility`.
double most_sum_error(const ImageFile& file, const std::string& visibility) {
    double most = 0;
    for (std::size_t i = 0; i < file.channel(visibility)->size(); ++i) {
        double sum = 0;
        for (const char* cause :
             {"cause.outside.Y", "cause.hidden.Y", "cause.grazing.Y", "cause.visible.Y"}) {
            sum += file.channel(cause)->pixels[i];
        }
        most = std::max(most, std::abs(sum - (1.0 - file.channel(visibility)->pixels[i])));
    }
    return most;
}

TEST(TruthFile, CausesAddUpToTheOcclusionOfTheFirstRadius) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "reference pillar --size 64x48 --radius 0.5,2 --samples 32 --causes --one-layer-bound --out t.exr",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile file = read_image(folder / "t.exr");
    EXPECT_LT(most_sum_error(file, "V0.Y"), 1e-6);
    EXPECT_GT(most_sum_error(file, "V1.Y"), 1e-3) << "the second radius has occlusion of its own";
    ASSERT_NE(file.channel("one_layer.Y"), nullptr);
    for (std::size_t i = 0; i < file.channel("Y")->size(); ++i) {
        EXPECT_LE(file.channel("one_layer.Y")->pixels[i], 1 - file.channel("Y")->pixels[i] + 1e-6);
    }
}

TEST(TruthFile, HoldsBentNormalsAndConesWhereAskedFor) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "reference pillar --size 64x48 --radius 1 --samples 32 --bent-normals --out t.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile file = read_image(folder / "t.exr");
    for (const char* name : {"bent.X", "bent.Y", "bent.Z", "SE.bent.Y", "cone.Y", "SE.cone.Y"})
        ASSERT_NE(file.channel(name), nullptr) << name;
    EXPECT_EQ(file.channel("cause.outside.Y"), nullptr) << "what was not asked for is not there";
    std::size_t closed_in = 0;
    for (std::size_t i = 0; i < file.channel("Y")->size(); ++i) {
        if (file.channel("mask.Y")->pixels[i] < 0.5F) continue;
        const double length = std::hypot(file.channel("bent.X")->pixels[i], file.channel("bent.Y")->pixels[i],
                                         file.channel("bent.Z")->pixels[i]);
        EXPECT_LE(length, 1 + 1e-6);
        const double cone(file.channel("cone.Y")->pixels[i]);
        EXPECT_NEAR(cone, std::numbers::pi / 2 * (1 - std::max(2 * length - 1, 0.0)), 1e-4);
        closed_in += cone < 1.2;
    }
    EXPECT_GT(closed_in, 50u) << "cones are narrower beside the pillar";
}

TEST(Score, ResultsSayCausesAndWhatTheTruthSaved) {
    const auto folder = output_dir();
    const auto run =
        run_aoscore("score pillar --methods alchemy --size 96x64 --error 0.001 --out page", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    for (const ViewRecord& view : results.views) {
        const ImageFile truth = read_image(folder / "page" / view.truth_file);
        EXPECT_LT(most_sum_error(truth, view.truths.at(0).channel), 1e-6);
        EXPECT_NE(truth.channel(view.one_layer_channel), nullptr);
        ASSERT_EQ(view.causes.size(), 4U);
        double sum = 0, occlusion = 0, valid = 0;
        for (const CauseRecord& cause : view.causes) {
            EXPECT_NE(truth.channel(cause.channel), nullptr) << cause.id;
            sum += cause.mean_occlusion;
        }
        for (std::size_t i = 0; i < truth.channel("Y")->size(); ++i) {
            if (truth.channel("mask.Y")->pixels[i] < 0.5F) continue;
            occlusion += 1.0 - truth.channel("Y")->pixels[i];
            valid += 1;
        }
        EXPECT_NEAR(sum, occlusion / valid, 1e-6) << view.key;

        const TruthSavings& saved = view.savings;
        EXPECT_EQ(saved.background_rays + saved.open_rays + saved.converged_rays + view.truth_rays,
                  saved.most_samples * 96 * 64)
            << view.key;
        EXPECT_GT(saved.converged_rays, 0U) << view.key;
        EXPECT_EQ(saved.background_rays, view.background_pixels * saved.most_samples) << view.key;
        EXPECT_EQ(saved.tiles, 12U * 8U) << view.key;
        EXPECT_LE(saved.untraced_tiles, saved.tiles) << view.key;
    }
}

}  // namespace
}  // namespace aoscore
