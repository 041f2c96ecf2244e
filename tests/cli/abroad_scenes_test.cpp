// One small scene as other programs write it; every form of it must give the truth of the glTF.
#include "image/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

struct Case {
    const char* file;
    const char* options;
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << c.file << " " << c.options;
}

class AbroadScene : public ::testing::TestWithParam<Case> {};

/// The mean visibility over the pixels that show a surface, and their number.
std::pair<double, int> mean_visibility(const fs::path& truth) {
    const ImageFile file = read_image(truth);
    const ImageF &visibility = *file.channel("Y"), &mask = *file.channel("mask.Y");
    double sum = 0;
    int pixels = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask.pixels[i] < 0.5F) continue;
        sum += visibility.pixels[i];
        ++pixels;
    }
    return {sum / pixels, pixels};
}

TEST_P(AbroadScene, GivesTheTruthOfItsGltf) {
    REQUIRE_SHARED_INPUTS();
    const fs::path folder = testing::output_dir(), abroad = fs::absolute(testing::shared_dir() / "abroad");
    const std::string views = std::string(GetParam().file).ends_with(".gltf")
                                  ? ""
                                  : " --views '" + (abroad / "base.views.json").string() + "'";
    const auto run =
        testing::run_aoscore("reference '" + (abroad / GetParam().file).string() + "' " + GetParam().options +
                                 views + " --view cam_a --size 96x64 --samples 64 --radius 1 --out x.exr",
                             folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto [mean, pixels] = mean_visibility(folder / "x.exr");
    EXPECT_EQ(pixels, 5036);
    EXPECT_NEAR(mean, 0.9445, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(Formats, AbroadScene,
                         ::testing::Values(Case{"base.gltf", ""}, Case{"base.obj", ""},
                                           Case{"base_cm.obj", "--unit cm"}, Case{"base_cm.obj", ""},
                                           Case{"base_negative_crlf.obj", ""}, Case{"roof_map_d.obj", ""},
                                           Case{"base.ply", ""}, Case{"base.ply", "--unit 1"}));

TEST(AbroadScenes, AViewFileOfAnotherUnitIsRefusedOnceTheUnitIsFixed) {
    REQUIRE_SHARED_INPUTS();
    const fs::path abroad = fs::absolute(testing::shared_dir() / "abroad");
    const auto run =
        testing::run_aoscore("gbuffer '" + (abroad / "base_cm.obj").string() + "' --unit m --views '" +
                                 (abroad / "base.views.json").string() + "' --out x.exr",
                             testing::output_dir());
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_THAT(run.err, HasSubstr("is for a scene with bounds"));
}

TEST(AbroadScenes, TheCommandOfAnAutomaticViewSaysUnitAndAxis) {
    const fs::path folder = testing::output_dir();
    std::ofstream(folder / "a.obj") << "v 0 0 0\nv 100 0 0\nv 100 0 100\nv 0 100 0\nf 1 2 3\nf 1 2 4\n";
    const auto run =
        testing::run_aoscore("reference a.obj --unit cm --up z --size 32x18 --samples 1 --out x.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(read_image(folder / "x.exr").attributes.at("comments"),
                HasSubstr("/a.obj --view auto_outside --unit cm --up z "));
}

TEST(AbroadScenes, UnitsThatAreNoneAreRefused) {
    for (const char* unit : {"yd", "0", "-1", "nan", "inf", "1e99", "1cm", ""}) {
        const auto run = testing::run_aoscore(std::string("gbuffer x.obj --out x.exr --unit '") + unit + "'",
                                              testing::output_dir());
        EXPECT_EQ(run.exit_code, 64) << unit << ": " << run.err;
    }
}

}  // namespace
}  // namespace aoscore
