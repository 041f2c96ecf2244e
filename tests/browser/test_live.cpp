#include "browser/browser_support.h"
#include "core/files.h"
#include "core/folders.h"
#include "image/image_file.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

/// The page's live methods are the program's: WebGL 2 draws what OpenGL 3.3 drew, cell by cell.
namespace aoscore {
namespace {

namespace fs = std::filesystem;

struct LiveCase {
    const char* name;
    const char* arguments;      ///< arguments of score after the scene
    double least_near = 0.995;  ///< share of the pixels that must be within 2/255
};

class LivePictures : public ::testing::TestWithParam<LiveCase> {};

TEST_P(LivePictures, EqualTheStoredOnes) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        std::string("score atrium --size 160x96 --samples 16 --quiet --out measured ") + GetParam().arguments,
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path measured = folder / "measured";
    write_atomically(folder / "values.json", testing::exr_values(read_results(measured), measured).dump());
    write_atomically(folder / "case.json", nlohmann::json{{"least_near", GetParam().least_near}}.dump());
    testing::expect_spec_holds("live-pictures.mjs", folder);
}

constexpr LiveCase kCases[] = {
    {"every_method", "--view close --methods all"},
    // Without a filter, taps and sectors that rounding pushes over an edge show in full.
    {"every_method_unfiltered", "--view close --methods all --filter none", 0.99},
    {"gaussian_depth", "--view wide --methods hbao,ssao --filter gaussian-depth"},
    {"normal_depth", "--view close --methods hbao,ssao --filter normal-depth"},
    {"border_clamp", "--view close --methods alchemy,gtao,xegtao --border clamp"},
    {"another_seed", "--seed 77 --view wide --methods ssao,alchemy,hbao"},
    {"depth_layers",
     "--seed 77 --view wide --methods sd-ssao,sd-hbao,sd-hbao-plus,sd-gtao,sd-bitmask --filter none", 0.99},
    {"depth_layers_hash_4d",
     "--view close --methods sd-ssao,sd-hbao-plus --set sampling=hash_4d --set depth_samples=7", 0.99},
    {"depth_layers_simple_hash",
     "--view close --methods sd-hbao,sd-gtao --set sampling=simple_hash --set per_sample=false", 0.99},
    {"depth_layers_peeled", "--view close --methods sd-ssao,sd-hbao,sd-hbao-plus,sd-bitmask --preset peeled",
     0.99},
    {"depth_layers_apart",
     "--view wide --methods sd-ssao,sd-hbao,sd-hbao-plus,sd-gtao --preset deep-g-buffer", 0.99},
    {"depth_layers_closed_meshes", "--view wide --methods sd-ssao --preset closed-meshes", 0.99},
    {"depth_layers_refused", "--view close --methods sd-hbao,ssao --set sampling=anisotropic"},
};
INSTANTIATE_TEST_SUITE_P(Page, LivePictures, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(LiveLayers, AreUnpackedWhenAMethodReadsThem) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        "score atrium --size 160x96 --samples 16 --methods gtao,sd-hbao --quiet --out measured", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    testing::expect_spec_holds("live-layers.mjs", folder);
}

/// The picture of the only cell.
ImageF picture_of(const fs::path& folder) {
    const Results results = read_results(folder);
    EXPECT_EQ(results.cells.size(), 1U);
    EXPECT_EQ(results.cells.at(0).error, "");
    return *read_image(folder / results.cells.at(0).image_file).channel("Y");
}

// A setting found on the page is the same one in the program, by its command line and as a preset.
TEST(LiveExport, MeasuresWhatThePageShowed) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const fs::path mine = folder / "methods" / "my-ssao";
    fs::create_directories(mine.parent_path());
    fs::copy(data_dir() / "shaders" / "methods" / "crytek-ssao", mine);
    testing::ProgramRun run = testing::run_aoscore(
        "score atrium --view close --size 160x96 --samples 16 --methods-dir methods --methods ssao --quiet "
        "--out measured",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    testing::expect_spec_holds("live-export.mjs", folder);

    const std::string command = read_file(folder / "command.txt"), program = "aoscore ";
    ASSERT_TRUE(command.starts_with(program)) << command;
    EXPECT_NE(command.find(" --methods-dir methods --methods my-ssao "), std::string::npos) << command;
    EXPECT_NE(command.find(" filter.taps=2"), std::string::npos) << command;
    run = testing::run_aoscore(command.substr(program.size()) + " --quiet --out by-command", folder);
    ASSERT_EQ(run.exit_code, 0) << command << run.err;
    const ImageF measured = picture_of(folder / "by-command");
    const std::string bytes = read_file(folder / "live.f32");
    ASSERT_EQ(bytes.size(), measured.size() * sizeof(float));
    std::vector<float> shown(measured.size());
    std::memcpy(shown.data(), bytes.data(), bytes.size());
    std::size_t near = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        near += std::abs(shown[i] - measured.pixels[i]) <= 2.0F / 255 ? 1 : 0;
    EXPECT_GE(static_cast<double>(near), 0.995 * static_cast<double>(shown.size()));

    // The preset is merged into the method's descriptor; it names its filter but has no values for it.
    nlohmann::json descriptor = nlohmann::json::parse(read_file(mine / "method.json"));
    descriptor.merge_patch(nlohmann::json::parse(read_file(folder / "preset.json")));
    write_atomically(mine / "method.json", descriptor.dump());
    run = testing::run_aoscore(
        "score atrium --view close --size 160x96 --samples 16 --methods-dir methods --methods my-ssao "
        "--preset live --border clamp --set filter.taps=2 --quiet --out by-preset",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(picture_of(folder / "by-preset").pixels, measured.pixels);
}

}  // namespace
}  // namespace aoscore
