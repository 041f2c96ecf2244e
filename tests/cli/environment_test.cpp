// Tests score --environment: its numbers, its files, its axes, its refusals.
#include "core/environment.h"

#include "core/files.h"
#include "image/image_file.h"
#include "results/light_modes.h"
#include "results/results.h"
#include "scene/camera.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScore =
    "score sphere --eye 0,6,1 --target 0,0,0 --size 64x36 --samples 64 --methods gtao,alchemy ";

/// A picture of `background` everywhere but for one patch of 20 degrees about a direction, which is white.
std::filesystem::path picture(const std::filesystem::path& folder, const glm::dvec3& towards,
                              float background) {
    EnvironmentMap map{Image<glm::vec3>(128, 64), 0};
    ImageF plane(128, 64, background);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            if (glm::dot(map.direction((x + 0.5) / 128, (y + 0.5) / 64), towards) > std::cos(0.35))
                plane.at(x, y) = 10;
        }
    }
    const auto path = folder / "patch.exr";
    write_exr(path, std::vector<ChannelView>{{"R", &plane}, {"G", &plane}, {"B", &plane}}, {});
    return path;
}

Results scored(const std::filesystem::path& folder, const std::string& options) {
    const auto run = run_aoscore(kScore + options, folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_results(folder / "page");
}

TEST(ScoreUnderAnEnvironment, KeepsTheTracedIrradianceAndWhatEveryMethodIsLitTo) {
    const auto folder = output_dir();
    const Results results = scored(folder, "--environment sky --out page");
    const ViewRecord& view = results.views.at(0);
    ASSERT_TRUE(view.light);
    EXPECT_EQ(view.light->environment, "sky");
    EXPECT_GT(view.light->mean, 0.1);
    EXPECT_GT(view.light->standard_error, 0);
    EXPECT_LT(view.light->standard_error, 0.01 * view.light->mean);
    const ImageFile traced = read_image(folder / "page" / view.light->file);
    for (const char* channel : {"R", "G", "B", "half_difference.R"})
        EXPECT_NE(traced.channel(channel), nullptr) << channel;
    for (const CellRecord& cell : results.cells) {
        const ImageFile lit = read_image(folder / "page" / cell.lit_file);
        for (const LightMode& mode : light_modes()) {
            const bool has = cell.method == "gtao" || mode.id == "normal";
            EXPECT_EQ(cell.light.contains(mode.relative_error()), has) << cell.id << ", " << mode.id;
            EXPECT_EQ(lit.channel(mode.channels()[1]) != nullptr, has) << cell.id << ", " << mode.id;
        }
    }
    for (const LightMode& mode : light_modes())
        EXPECT_TRUE(view.light->of_truth.contains(mode.error())) << mode.id;
    const std::string page = read_file(folder / "page" / "index.html");
    EXPECT_NE(page.find("alt=\"Ray-traced irradiance on " + view.key), std::string::npos);
}

TEST(ScoreUnderAnEnvironment, TracesNothingTwice) {
    const auto folder = output_dir();
    const Results first = scored(folder, "--environment sky --out page");
    const auto listed = run_aoscore(std::string(kScore) + "--environment sky --out page --jobs", folder);
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    std::size_t kept = 0;
    const nlohmann::json jobs = nlohmann::json::parse(listed.out).at("jobs");
    for (const nlohmann::json& job : jobs) {
        const std::string kind = job.at("kind");
        if (kind != "irradiance" && kind != "view_light" && kind != "light" && kind != "lit_file") continue;
        EXPECT_TRUE(job.at("known")) << kind << " of " << job.at("about");
        ++kept;
    }
    EXPECT_EQ(kept, 2 + 2 * first.cells.size());
    const Results again = scored(folder, "--environment sky --out page");
    EXPECT_EQ(to_json(again.cells[0]).at("light"), to_json(first.cells[0]).at("light"));
}

// Under even light of radiance L the irradiance is pi L V, whatever the normal is: methods err by as much as
// their visibility does, and the truth's own visibility by its noise alone.
TEST(ScoreUnderAnEnvironment, ThatIsEvenErrsAsVisibilityDoes) {
    const auto folder = output_dir();
    const auto path = picture(folder, {0, 1, 0}, 10);
    const Results results = scored(folder, "--environment " + path.string() + " --out page");
    const ViewRecord& view = results.views.at(0);
    ASSERT_TRUE(view.light);
    for (const char* mode : {"normal", "bent_normal", "cone"})
        EXPECT_LT(view.light->of_truth.at(std::string("relative_rmse.") + mode).value, 0.02) << mode;
    for (const CellRecord& cell : results.cells) {
        const double expected = *cell.ranked.at("rmse_debiased").value;
        for (const auto& [id, measure] : cell.light) {
            if (!id.starts_with("rmse.") || id == "rmse.cone_alone") continue;
            EXPECT_NEAR(measure.value / 10, expected, 0.03 * expected + 0.002) << cell.id << ", " << id;
        }
    }
}

/// The mean world normal of a view's pixels, weighted by how bright they are.
glm::dvec3 lit_side(const ViewRecord& view, const std::filesystem::path& folder, const ImageF& bright) {
    const ImageFile gbuffer = read_image(folder / view.gbuffer_file);
    const ImageFile truth = read_image(folder / view.truth_file);
    Camera camera;
    camera.position = {view.position_m[0], view.position_m[1], view.position_m[2]};
    camera.target = {view.target_m[0], view.target_m[1], view.target_m[2]};
    camera.up = {view.up[0], view.up[1], view.up[2]};
    const glm::dmat3 world(CameraFrame(camera, view.width, view.height).world_from_view());
    glm::dvec3 sum(0), all(0);
    double count = 0, light = 0;
    for (std::size_t i = 0; i < bright.size(); ++i) {
        if (truth.channel("mask.Y")->pixels[i] < 0.5F) continue;
        const glm::dvec3 normal =
            world * glm::dvec3(gbuffer.channel("N.X")->pixels[i], gbuffer.channel("N.Y")->pixels[i],
                               gbuffer.channel("N.Z")->pixels[i]);
        sum += double{bright.pixels[i]} * normal;
        light += double{bright.pixels[i]};
        all += normal;
        count += 1;
    }
    return glm::normalize(sum / light - all / count);
}

// A mirrored or turned axis anywhere on the way would light another side.
TEST(ScoreUnderAnEnvironment, LightsTheSideThatFacesItsBrightPatch) {
    for (const glm::dvec3& towards : {glm::dvec3(0.8, 0.6, 0), glm::dvec3(-0.8, 0.6, 0),
                                      glm::dvec3(0, 0.6, 0.8), glm::dvec3(0, 0.6, -0.8)}) {
        const auto folder = output_dir();
        const auto path = picture(folder, towards, 0.01F);
        const Results results = scored(folder, "--environment " + path.string() + " --out page");
        const ViewRecord& view = results.views.at(0);
        const CellRecord& cell = results.cells.at(0);
        ASSERT_EQ(cell.method, "gtao");
        const glm::dvec3 flat = glm::normalize(glm::dvec3(towards.x, 0, towards.z));
        const auto faces = [&](const ImageF& bright) {
            const glm::dvec3 side = lit_side(view, folder / "page", bright);
            return glm::dot(glm::normalize(glm::dvec3(side.x, 0, side.z)), flat);
        };
        EXPECT_GT(faces(*read_image(folder / "page" / view.light->file).channel("G")), 0.9);
        const ImageFile lit = read_image(folder / "page" / cell.lit_file);
        for (const LightMode& mode : light_modes())
            EXPECT_GT(faces(*lit.channel(mode.channels()[1])), 0.8)
                << mode.id << ", " << towards.x << ", " << towards.z;
    }
}

TEST(ScoreUnderAnEnvironment, TurnsIt) {
    const auto folder = output_dir();
    const auto path = picture(folder, {0.8, 0.6, 0}, 0.01F);
    const Results results =
        scored(folder, "--environment " + path.string() + " --environment-turn 90 --out page");
    const ViewRecord& view = results.views.at(0);
    const ImageFile traced = read_image(folder / "page" / view.light->file);
    EXPECT_LT(lit_side(view, folder / "page", *traced.channel("G")).z, -0.5) << "+x turns to -z";
    EXPECT_THAT(view.light->environment, HasSubstr("turned by 90°"));
}

TEST(ScoreUnderAnEnvironment, LightsByTheNormalAloneWhereMethodsGiveNoSignals) {
    const auto folder = output_dir();
    for (const std::string resolution : {"half", "dual"}) {
        const auto run = run_aoscore(
            kScore + ("--environment sky --out page --resolution " + resolution), folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        EXPECT_THAT(run.err, HasSubstr("are lit by the surface's normal alone"));
        for (const CellRecord& cell : read_results(folder / "page").cells) {
            ASSERT_EQ(cell.error, "");
            for (const LightMode& mode : light_modes())
                EXPECT_EQ(cell.light.contains(mode.error()), !mode.bent) << cell.id << ", " << mode.id;
        }
    }
}

TEST(ScoreUnderAnEnvironment, LeavesNoPictureToARunWithoutIt) {
    const auto folder = output_dir();
    const Results lit = scored(folder, "--environment sky --out page");
    const auto is_there = [&](const std::string& file) {
        return std::filesystem::exists(folder / "page" / file);
    };
    ASSERT_TRUE(is_there(lit.views.at(0).light->file));
    ASSERT_TRUE(is_there(lit.cells.front().lit_file));
    write_atomically(folder / "page/cells/notes.txt", "of the user");
    const Results plain = scored(folder, "--out page");
    EXPECT_FALSE(is_there(lit.views.at(0).light->file));
    for (const CellRecord& cell : lit.cells) EXPECT_FALSE(is_there(cell.lit_file)) << cell.lit_file;
    for (const CellRecord& cell : plain.cells) EXPECT_TRUE(is_there(cell.image_file)) << cell.image_file;
    EXPECT_TRUE(is_there(plain.views.at(0).truth_file));
    EXPECT_TRUE(is_there("cells/notes.txt"));
}

TEST(ScoreUnderAnEnvironment, GatesEveryErrorThatAModeHas) {
    const auto folder = output_dir();
    const Results results = scored(folder, "--environment sky --out page");
    const CellRecord& cell = results.cells.front();
    for (const LightMode& mode : light_modes()) {
        for (const std::string& id : mode.measures()) EXPECT_TRUE(cell.light.contains(id)) << id;
    }
}

TEST(ScoreUnderAnEnvironment, RefusesWhatItCannotLightBy) {
    const auto folder = output_dir();
    const auto refused = [&](const std::string& options) {
        return run_aoscore(kScore + options + " --out page", folder);
    };
    EXPECT_EQ(refused("--environment absent.hdr").exit_code, 4);
    EXPECT_EQ(refused("--environment-turn 10").exit_code, 64);
    EXPECT_EQ(refused("--environment sky --environment-turn 10").exit_code, 64);
    for (const std::string turn : {"nan", "inf", "1e30", "-361"}) {
        const auto turned = refused("--environment light.hdr --environment-turn=" + turn);
        EXPECT_EQ(turned.exit_code, 64) << turn;
        EXPECT_THAT(turned.err, HasSubstr("number from -360 to 360")) << turn;
    }
    const ImageF square(8, 8, 1);
    write_exr(folder / "square.exr", std::vector<ChannelView>{{"R", &square}, {"G", &square}, {"B", &square}},
              {});
    const auto shape = refused("--environment square.exr");
    EXPECT_EQ(shape.exit_code, 4);
    EXPECT_THAT(shape.err, HasSubstr("twice as wide as high"));
    const auto frame =
        run_aoscore("score --gbuffer a.exr --truth b.exr --radius 1 --environment sky --out page", folder);
    EXPECT_EQ(frame.exit_code, 64);
    EXPECT_THAT(frame.err, HasSubstr("--environment"));
}

}  // namespace
}  // namespace aoscore
