// Tests whole runs through the program: truth files, pages, a user's methods, real scenes.
#include "core/files.h"
#include "image/image_file.h"
#include "readme.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

TEST(Reference, FileHoldsOneVisibilityForEachRadiusWithTheRadiiInTheHeader) {
    const auto folder = output_dir();
    const auto run =
        run_aoscore("reference wall --size 48x32 --radius 0.5,inf --samples 8 --out truth.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile file = read_image(folder / "truth.exr");
    for (const char* name : {"Y", "V0.Y", "V1.Y", "SE.Y", "mask.Y"})
        EXPECT_NE(file.channel(name), nullptr) << name;
    EXPECT_EQ(file.channel("Y")->pixels, file.channel("V0.Y")->pixels);
    EXPECT_EQ(file.attributes.at("aoscore:V0.radius_m"), "0.5");
    EXPECT_EQ(file.attributes.at("aoscore:V1.radius_m"), "infinite");
    for (std::size_t i = 0; i < file.channel("Y")->size(); ++i) {
        EXPECT_GE(file.channel("V0.Y")->pixels[i], file.channel("V1.Y")->pixels[i])
            << "a longer ray cannot see less";
    }
}

TEST(Reference, ImageDoesNotDependOnTheThreadCount) {
    const auto folder = output_dir();
    for (const char* threads : {"1", "2"}) {
        const std::string n = threads;
        const auto run =
            run_aoscore("reference sphere --size 64x48 --samples 16 --radius 1 --no-cache --threads " + n +
                            " --out t" + n + ".exr",
                        folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    const ImageFile one = read_image(folder / "t1.exr"), two = read_image(folder / "t2.exr");
    EXPECT_EQ(one.channel("Y")->pixels, two.channel("Y")->pixels);
    EXPECT_EQ(one.channel("SE.Y")->pixels, two.channel("SE.Y")->pixels);
}

TEST(Gbuffer, FileHoldsDepthNormalsAndAlbedo) {
    const auto folder = output_dir();
    const auto run = run_aoscore("gbuffer sphere --size 64x48 --out g.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile file = read_image(folder / "g.exr");
    for (const char* name : {"Z", "N.X", "N.Y", "N.Z", "Ns.X", "Ns.Y", "Ns.Z", "albedo.R", "mask.Y"}) {
        EXPECT_NE(file.channel(name), nullptr) << name;
    }
}

// The ray march would cost more than all other methods together.
TEST(Score, RunsAMethodAsItsDescriptorSaysAndShowsIt) {
    const auto folder = output_dir();
    const auto run =
        run_aoscore("score wall --methods ray-march,ssao --size 48x32 --samples 4 --out page", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("warning: ray-march is drawn with resolution half"));
    EXPECT_THAT(read_file(folder / "page/index.html"), HasSubstr("ray-march is drawn with resolution half"));
    const Results results = read_results(folder / "page");
    std::map<std::string, nlohmann::json> resolutions;
    for (const CellRecord& cell : results.cells) {
        const auto mode = cell.parameters.find("resolution");
        resolutions[cell.method + "/" + cell.preset] = mode == cell.parameters.end() ? "full" : mode->second;
    }
    const std::map<std::string, nlohmann::json> expected{{"ray-march/default", "half"},
                                                         {"ssao/default", "full"}};
    EXPECT_EQ(resolutions, expected);

    const auto asked = run_aoscore(
        "score wall --methods ray-march --preset solid --resolution full --size 48x32 --samples 4 --out full",
        folder);
    ASSERT_EQ(asked.exit_code, 0) << asked.err;
    EXPECT_THAT(asked.err, ::testing::Not(HasSubstr("is drawn with")));
    const Results full = read_results(folder / "full");
    for (const CellRecord& cell : full.cells) {
        EXPECT_EQ(cell.preset, "solid");
        EXPECT_FALSE(cell.parameters.contains("resolution"));
    }
}

TEST(Score, PrintsThePathOfAPageAndKeepsItsResults) {
    const auto folder = output_dir();
    const auto run = run_aoscore("score wall --size 96x64 --samples 8 --out page", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "page/index.html\n");
    EXPECT_TRUE(std::filesystem::exists(folder / "page/index.html"));
    const Results results = read_results(folder / "page");
    ASSERT_FALSE(results.cells.empty());
    for (const CellRecord& cell : results.cells) {
        EXPECT_TRUE(cell.error.empty()) << cell.id << ": " << cell.error;
        ASSERT_TRUE(cell.ranked.contains("rmse")) << cell.id;
        EXPECT_TRUE(cell.ranked.at("rmse").value) << cell.id;
        EXPECT_TRUE(cell.ao.median_ms) << cell.id;
        EXPECT_GE(cell.ao.runs_ms.size(), 3u) << cell.id;
        EXPECT_GT(cell.fetches_per_pixel.value_or(0), 0) << cell.id;
        EXPECT_TRUE(std::filesystem::exists(folder / "page" / cell.image_file)) << cell.id;
    }
    const std::string page = read_file(folder / "page/index.html");
    ASSERT_EQ(run_aoscore("page page", folder).exit_code, 0);
    EXPECT_EQ(read_file(folder / "page/index.html"), page) << "the page comes from the results alone";
}

constexpr const char* kOwnDescriptor = R"({
  "label": "Constant half",
  "paper": "Nobody, A method of one's own, 2026",
  "summary": "Reads the depth and says 0.5",
  "parameters": {"level": {"type": "real", "default": 0.5, "range": [0, 1], "unit": "", "meaning": "What it says"}},
  "passes": [{"fragment": "ao.frag", "inputs": ["linear_depth"]}],
  "truth": {"falloff": "binary"}
})";

// README.md walks a user through copying a folder. The editor writes a label and another estimator.
TEST(OwnMethod, CommandsOfTheReadmeListAndScoreACopiedAndChangedFolderWithoutARebuild) {
    const auto folder = output_dir();
    std::ofstream(folder / "editor.sh")
        << "sed -i -e 's|\"label\": \"[^\"]*\"|\"label\": \"My <b>Alchemy</b>\"|' \\\n"
           "  -e 's|return pow(max(0.0, 1.0 - sum), p_kappa);|return 0.0;|' \"$1\"\n";
    const std::string section = "A method of your own";
    const std::string commands = testing::readme_commands(section);
    for (const char* line : {"cp -r shaders/methods/alchemy mine/my-alchemy\n",
                             "$EDITOR mine/my-alchemy/method.json", "$EDITOR mine/my-alchemy/ao.frag",
                             "./run.sh list methods --methods-dir mine\n", "./run.sh score atrium --methods"})
        ASSERT_THAT(commands, HasSubstr(line));

    ::setenv("EDITOR", "bash editor.sh", 1);
    const auto run = testing::run_readme_commands(section, folder, "--size 96x54 --samples 4 --out page");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("\nmy-alchemy "));
    const Results results = read_results(folder / "page");
    ASSERT_FALSE(results.views.empty());
    std::map<std::string, double> rmse;
    for (const CellRecord& cell : results.cells) {
        EXPECT_THAT(cell.error, ::testing::IsEmpty());
        rmse[cell.view_key + cell.method] = *cell.ranked.at("rmse").value;
    }
    for (const ViewRecord& view : results.views) {
        EXPECT_GT(rmse.at(view.key + "my-alchemy"), rmse.at(view.key + "alchemy") + 0.1)
            << "the copy closes everything";
    }
    EXPECT_THAT(read_file(folder / "page/index.html"), ::testing::Not(HasSubstr("My <b>Alchemy</b>")))
        << "a label is text, not markup";
}

TEST(OwnMethod, ABrokenShaderFailsItsCellAndTheOthersGoOn) {
    const auto folder = output_dir();
    std::filesystem::create_directories(folder / "mine/broken");
    std::ofstream(folder / "mine/broken/method.json") << kOwnDescriptor;
    std::ofstream(folder / "mine/broken/ao.frag")
        << "void main() { o_visibility = p_level this is no GLSL; }\n";
    const auto run = run_aoscore(
        "score wall --size 64x48 --samples 4 --methods alchemy,broken --methods-dir mine --out page", folder);
    EXPECT_EQ(run.exit_code, 5) << run.err;
    const Results results = read_results(folder / "page");
    for (const CellRecord& cell : results.cells)
        EXPECT_EQ(cell.error.empty(), cell.method == "alchemy") << cell.error;
    EXPECT_THAT(read_file(folder / "page/index.html"), HasSubstr("failed"));
}

TEST(Score, ModesAndParametersAreTakenAndRecorded) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "score wall --view oblique --methods alchemy,gtao --set radius=0.25 --normals from-depth-accurate "
        "--resolution half --precision packed-rgba8 --border clamp --guard-band 10% --filter none --error "
        "0.05 --size 96x64 "
        "--out page",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    ASSERT_EQ(results.cells.size(), 2u);
    for (const CellRecord& cell : results.cells) {
        EXPECT_EQ(cell.parameters.at("radius"), 0.25) << cell.id;
        EXPECT_EQ(cell.parameters.at("normals"), "from-depth-accurate") << cell.id;
        EXPECT_EQ(cell.parameters.at("resolution"), "half") << cell.id;
        EXPECT_EQ(cell.parameters.at("border"), "clamp") << cell.id;
        EXPECT_EQ(cell.parameters.at("guard-band"), "10%") << cell.id;
        EXPECT_FALSE(cell.gbuffer.runs_ms.empty()) << cell.id;
        EXPECT_EQ(cell.gbuffer_bytes, 116 * 78 * 4 * (1 + 1 + 4 + 4))
            << "window depth, view depth, geometric and smooth normals of four floats";
        EXPECT_EQ(cell.filter, "none") << cell.id;
    }
    EXPECT_EQ(results.views.at(0).max_error, 0.05);
}

class RealScene : public ::testing::TestWithParam<const char*> {};

TEST_P(RealScene, GivesAPageWithEveryMethodScored) {
    REQUIRE_SHARED_INPUTS();
    const auto folder = output_dir();
    const auto scene = testing::shared_dir() / "scenes" / GetParam();
    const auto run =
        run_aoscore("score '" + scene.string() + "' --size 160x90 --samples 4 --out page", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    for (const CellRecord& cell : results.cells)
        EXPECT_TRUE(cell.error.empty()) << cell.id << ": " << cell.error;
    for (const ViewRecord& view : results.views) EXPECT_GT(view.valid_pixels, 0u) << view.key;
}

INSTANTIATE_TEST_SUITE_P(All, RealScene,
                         ::testing::Values("cornell_original.glb", "fireplace_room.glb", "flight_helmet.glb",
                                           "hairball_synthetic.glb", "sibenik.glb", "sponza_crytek.glb",
                                           "staircase.glb", "stanford_group.glb"),
                         [](const auto& param_info) {
                             const std::string name = param_info.param;
                             return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace aoscore
