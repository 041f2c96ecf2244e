// Tests the path of an outside method as README shows it: export, render elsewhere, compare.
#include "image/image_file.h"
#include "readme.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

namespace aoscore {
namespace {

using testing::output_dir;

TEST(RoundTrip, CommandsOfTheReadmeScoreAnImageMadeElsewhere) {
    if (std::system("command -v oiiotool >/dev/null") != 0) {
        GTEST_SKIP() << "oiiotool is not there (Debian: openimageio-tools)";
    }
    const auto folder = output_dir();
    const std::string section = "An image of another engine";
    ASSERT_THAT(testing::readme_commands(section), ::testing::HasSubstr("./run.sh compare"));
    const auto run = testing::run_readme_commands(section, folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    // The output shows that the image was understood: the channel by its name, an error like that of a
    // method, and no doubts.
    EXPECT_THAT(run.out, ::testing::ContainsRegex("test_channel +AO  named as ambient occlusion"));
    std::map<std::string, double> numbers;
    std::string measure, value, rest;
    for (std::istringstream lines(run.out); lines >> measure >> value && std::getline(lines, rest);)
        numbers[measure] = std::atof(value.c_str());
    EXPECT_GT(numbers["rmse_debiased"], 0.05);
    EXPECT_LT(numbers["rmse_debiased"], 0.2);
    EXPECT_LT(std::abs(numbers["bias"]), 0.12);
    EXPECT_THAT(run.err, ::testing::Not(::testing::HasSubstr("warning")));
    const ImageFile gbuffer = read_image(folder / "gbuffer.exr");
    for (const char* name : {"Z", "P.X", "P.Y", "P.Z", "N.X", "Ns.Z", "albedo.R", "mask.Y"})
        EXPECT_NE(gbuffer.channel(name), nullptr) << name;
    for (const char* name : {"worldToCamera", "worldToNDC", "aoscore:near_m", "aoscore:fovy_deg"})
        EXPECT_TRUE(gbuffer.attributes.contains(name)) << name;
}

TEST(RoundTrip, PositionsOfTheGbufferAreItsDepthOnTheRaysOfItsMatrix) {
    const auto folder = output_dir();
    const auto run = testing::run_aoscore("gbuffer sphere --size 64x48 --out g.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile file = read_image(folder / "g.exr");
    std::istringstream ndc(file.attributes.at("worldToNDC")), camera(file.attributes.at("worldToCamera"));
    std::vector<double> to_ndc(16), to_camera(16);
    for (double& number : to_ndc) ndc >> number;
    for (double& number : to_camera) camera >> number;
    const auto& mask = *file.channel("mask.Y");
    int drawn = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            if (mask.at(x, y) < 0.5F) continue;
            ++drawn;
            const double view[3] = {file.channel("P.X")->at(x, y), file.channel("P.Y")->at(x, y),
                                    file.channel("P.Z")->at(x, y)};
            EXPECT_FLOAT_EQ(static_cast<float>(-view[2]), file.channel("Z")->at(x, y));
            // The rotation's transpose takes the view's position back to the world; points are row vectors.
            double world[4] = {0, 0, 0, 1}, clip[4] = {0, 0, 0, 0};
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j)
                    world[i] += (view[j] - to_camera[12 + j]) * to_camera[4 * i + j];
            }
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t i = 0; i < 4; ++i) clip[j] += world[i] * to_ndc[4 * i + j];
            }
            EXPECT_NEAR((clip[0] / clip[3] + 1) / 2 * 64, x + 0.5, 0.01);
            EXPECT_NEAR((1 - clip[1] / clip[3]) / 2 * 48, y + 0.5, 0.01);
        }
    }
    EXPECT_GT(drawn, 100);
}

}  // namespace
}  // namespace aoscore
