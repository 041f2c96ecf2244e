// Tests `aoscore compare` with images as other programs write them: the channel that is taken, refusals, and
// warnings about pictures that may have been meant otherwise.
#include "core/files.h"
#include "image/image_file.h"
#include "support/foreign_exr.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

constexpr int kWidth = 64, kHeight = 48;

/// Occlusion in a corner and along a wall, which no mirroring maps to itself.
ImageF truth_image() {
    ImageF image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float corner = std::hypot(static_cast<float>(x - 10), static_cast<float>(y - 8)) / 20;
            const float wall = static_cast<float>(kHeight - 1 - y) / 10;
            image.at(x, y) = std::min({1.0F, 0.1F + 0.9F * corner, 0.3F + 0.7F * wall});
        }
    }
    return image;
}

ImageF changed(const ImageF& image, const std::function<double(double)>& change) {
    ImageF result = image;
    for (float& value : result.pixels) value = static_cast<float>(change(static_cast<double>(value)));
    return result;
}

double coded(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The truth with an error: a regular pattern of .05 that no other reading removes.
ImageF good_test() {
    ImageF image = truth_image();
    for (std::size_t i = 0; i < image.size(); ++i)
        image.pixels[i] = std::clamp(image.pixels[i] + (i % 3 == 0 ? 0.05F : -0.03F), 0.0F, 1.0F);
    return image;
}

class CompareAbroad : public ::testing::Test {
  protected:
    void SetUp() override { write("truth.exr", truth_image()); }

    void write(const std::string& name, const ImageF& image) const {
        write_exr(folder_ / name, std::vector<ChannelView>{{"Y", &image}}, {});
    }
    ProgramRun compare(const std::string& arguments) const {
        return run_aoscore("compare truth.exr " + arguments, folder_);
    }
    json compared(const std::string& arguments) const {
        const ProgramRun run = compare(arguments + " --json -");
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return json::parse(run.out, nullptr, false);
    }

    std::filesystem::path folder_ = output_dir();
};

// ../shared/abroad/manifest.json describes each file, with the right answer.
TEST(SharedAbroad, EachImageIsScoredRightOrRefusedInWords) {
    REQUIRE_SHARED_INPUTS();
    const auto folder = output_dir();
    const std::string abroad = "'" + (testing::shared_dir() / "abroad").string() + "'/";
    constexpr double kRight = 0.049431;
    const struct {
        const char *file, *arguments, *channel;
    } right[] = {{"clay_and_ao.exr", "", "AO.R"},
                 {"mp_ao_first.exr", "--channel AO.R", "AO.R"},
                 {"mp_ao_first.exr", "", "AO.R"},
                 {"camel.exr", "", "AmbientOcclusion.R"},
                 {"orient4.tif", "", "Y"},
                 {"over1.exr", "", "Y"},
                 {"crop.exr", "--crop 10,8,40,32", "Y"}};
    for (const auto& image : right) {
        const ProgramRun run = run_aoscore(
            "compare " + abroad + "t.exr " + abroad + image.file + " " + image.arguments + " --json -",
            folder);
        ASSERT_EQ(run.exit_code, 0) << image.file << "\n" << run.err;
        const json result = json::parse(run.out);
        EXPECT_EQ(result["test_channel"], image.channel) << image.file;
        const std::string name = image.file;
        // These two have other pixels than the rest: values beyond 1, and a part of the picture.
        if (name != "over1.exr" && name != "crop.exr") {
            EXPECT_NEAR(result["metrics"]["rmse"]["value"].get<double>(), kRight, 2e-6) << image.file;
        }
        EXPECT_EQ(result["valid_pixels"], name == "crop.exr" ? 40 * 32 : 64 * 48) << image.file;
        EXPECT_EQ(run.err.find("above 1") != std::string::npos, name == "over1.exr") << run.err;
    }
    const ProgramRun depth =
        run_aoscore("compare " + abroad + "t.exr " + abroad + "colour_and_scenedepth.exr", folder);
    EXPECT_EQ(depth.exit_code, 4) << depth.out;
    EXPECT_THAT(depth.err, HasSubstr("no channel of visibility among R, G, B, SceneDepth.R"));
    EXPECT_EQ(
        run_aoscore("compare " + abroad + "t.exr " + abroad + "t.exr --fail 'rmse > 0.02'", folder).exit_code,
        0);
}

TEST_F(CompareAbroad, TheChannelsTakenArePrintedAndInTheJson) {
    const ImageF truth = truth_image(), other(kWidth, kHeight, 0.5F);
    write_exr(folder_ / "engine.exr",
              std::vector<ChannelView>{{"R", &other}, {"G", &other}, {"B", &other}, {"SSAO.R", &truth}}, {});
    const ProgramRun run = compare("engine.exr");
    EXPECT_THAT(run.out, ::testing::ContainsRegex("test_channel +SSAO.R  named as ambient occlusion"));
    EXPECT_THAT(run.out, ::testing::ContainsRegex("truth_channel +Y  the only picture"));
    const json result = compared("engine.exr");
    EXPECT_EQ(result["test_channel"], "SSAO.R");
    EXPECT_EQ(result["test_channel_why"], "named as ambient occlusion");
    EXPECT_EQ(result["metrics"]["rmse"]["value"], 0.0);
}

TEST_F(CompareAbroad, ThePageShowsTheChannelsTheWarningsAndThePictures) {
    const ImageF occlusion = changed(truth_image(), [](double v) { return 1 - v; });
    write_exr(folder_ / "engine<1>.exr", std::vector<ChannelView>{{"SSAO.R", &occlusion}}, {});
    const ProgramRun run = compare("'engine<1>.exr' --page out/page.html --fail 'rmse > 0.1'");
    EXPECT_EQ(run.exit_code, 2) << run.err;
    const std::string page = read_file(folder_ / "out" / "page.html");
    EXPECT_THAT(
        page, HasSubstr("engine&lt;1&gt;.exr: channel <strong>SSAO.R</strong>, named as ambient occlusion"));
    EXPECT_THAT(page, HasSubstr("truth.exr: channel <strong>Y</strong>, the only picture"));
    EXPECT_THAT(page, HasSubstr("Doubtful: the picture runs against the truth"));
    EXPECT_THAT(page, HasSubstr("Failed: rmse&gt;0.1"));
    std::size_t pictures = 0;
    for (auto at = page.find("data:image/png;base64,"); at != std::string::npos;
         at = page.find("data:image/png;base64,", at + 1))
        ++pictures;
    EXPECT_EQ(pictures, 3U);
    EXPECT_THAT(page, Not(HasSubstr("http://")));
    EXPECT_THAT(page, Not(HasSubstr("https://")));
    EXPECT_THAT(page, Not(HasSubstr(">nan")));
}

TEST_F(CompareAbroad, AnExactOrMerelyWrongPictureHasNoWarning) {
    write("good.exr", good_test());
    write("half.exr", changed(truth_image(), [](double v) { return 1 - (1 - v) / 2; }));
    for (const char* name : {"truth.exr", "good.exr", "half.exr"})
        EXPECT_EQ(compared(name)["warnings"], json::array()) << name;
}

TEST_F(CompareAbroad, ValuesBeyondZeroAndOneAreCounted) {
    ImageF beyond = truth_image();
    beyond.at(3, 4) = 1.25F;
    beyond.at(5, 6) = 1.5F;
    beyond.at(7, 8) = -0.25F;
    beyond.at(9, 9) = 1.0005F;  // rounding
    write("beyond.exr", beyond);
    EXPECT_THAT(compare("beyond.exr").err,
                HasSubstr("of 3072 pixels 1 are below 0 and 2 above 1 (from -0.25 to 1.5)"));
}

TEST_F(CompareAbroad, APictureMeantOtherwiseIsAWarningThatNamesTheOption) {
    const ImageF good = good_test();
    const auto turned = [&](bool upside_down, bool mirrored) {
        ImageF result = good;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x)
                result.at(x, y) = good.at(mirrored ? kWidth - 1 - x : x, upside_down ? kHeight - 1 - y : y);
        }
        return result;
    };
    const struct {
        const char* name;
        ImageF image;
        const char *said, *option;
    } pictures[] = {
        {"flipped.exr", turned(true, false), "upside down", "--flip"},
        {"mirrored.exr", turned(false, true), "mirrored", "--mirror"},
        {"turned.exr", turned(true, true), "upside down and mirrored", "--flip --mirror"},
        {"occlusion.exr", changed(good, [](double v) { return 1 - v; }), "runs against the truth",
         "--invert"},
        {"coded.exr", changed(good, coded), "sRGB-coded", "--srgb-floats"},
        {"coded_occlusion.exr", changed(good, [](double v) { return coded(1 - v); }),
         "runs against the truth", "--invert --srgb-floats"},
    };
    const double right = [&] {
        write("good.exr", good);
        return compared("good.exr")["metrics"]["rmse"]["value"].get<double>();
    }();
    for (const auto& picture : pictures) {
        write(picture.name, picture.image);
        const json given = compared(picture.name);
        EXPECT_THAT(given["warnings"].dump(), HasSubstr(picture.said)) << picture.name;
        EXPECT_GT(given["metrics"]["rmse"]["value"].get<double>(), 1.5 * right) << picture.name;
        const json read = compared(std::string(picture.name) + " " + picture.option);
        EXPECT_EQ(read["warnings"], json::array()) << picture.name;
        EXPECT_NEAR(read["metrics"]["rmse"]["value"].get<double>(), right, 1e-6) << picture.name;
        std::string option;
        for (std::istringstream options(picture.option); options >> option;)
            EXPECT_THAT(compare(picture.name).err, HasSubstr(option)) << picture.name;
    }
    write("decoded.exr", changed(good, decoded));
    EXPECT_THAT(compare("decoded.exr").err, HasSubstr("linear already"));
}

TEST_F(CompareAbroad, IntegersReadWithTheWrongCodingAreAWarning) {
    const auto write_png = [&](const char* name, double (*coding)(double)) {
        Image<std::uint8_t> levels(kWidth, kHeight);
        const ImageF image = good_test();
        for (std::size_t i = 0; i < image.size(); ++i)
            levels.pixels[i] =
                static_cast<std::uint8_t>(std::lround(coding(static_cast<double>(image.pixels[i])) * 255));
        write_atomically(folder_ / name, encode_png_gray(levels));
    };
    write_png("coded.png", coded);
    write_png("linear.png", [](double v) { return v; });
    EXPECT_EQ(compared("coded.png --srgb")["warnings"], json::array());
    EXPECT_EQ(compared("linear.png --linear")["warnings"], json::array());
    EXPECT_THAT(compare("coded.png --linear").err, HasSubstr("try --srgb"));
    EXPECT_THAT(compare("linear.png --srgb").err, HasSubstr("try --linear"));
}

TEST_F(CompareAbroad, APictureOfSomethingElseIsDoubted) {
    ImageF checkers(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) checkers.at(x, y) = (x / 8 + y / 8) % 2 == 0 ? 0.2F : 0.9F;
    }
    write("checkers.exr", checkers);
    EXPECT_THAT(compare("checkers.exr").err, HasSubstr("hardly follows the truth"));
}

TEST_F(CompareAbroad, ACropInADataWindowIsComparedWhereItIs) {
    const ImageF truth = truth_image();
    ImageF part(20, 10);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 20; ++x) part.at(x, y) = truth.at(x + 7, y + 30);
    }
    testing::write_parts(folder_ / "crop.exr", {{"", {{"Y", &part}}, 7, 30}}, kWidth, kHeight);
    for (const char* arguments : {"crop.exr", "crop.exr --crop 7,30,20,10", "crop.exr --crop 0,0,64,48"}) {
        const json result = compared(arguments);
        EXPECT_EQ(result["metrics"]["max_error"]["value"], 0.0) << arguments;
        EXPECT_EQ(result["valid_pixels"], 200) << arguments;
        EXPECT_EQ(result["warnings"].empty(), std::string(arguments).find("7,30") != std::string::npos);
    }
    EXPECT_THAT(compare("crop.exr").err,
                HasSubstr("holds 20x10 pixels at 7, 30 of the 64x48 compared: the others do not count"));
    EXPECT_EQ(compare("crop.exr --crop 0,0,5,5").exit_code, 2) << "nothing to compare";
}

TEST_F(CompareAbroad, TheChannelOfAMaskIsFoundOrNamed) {
    ImageF spoilt = truth_image(), left(kWidth, kHeight), other(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            left.at(x, y) = x < 40 ? 1.0F : 0.0F;
            if (x >= 40) spoilt.at(x, y) = 0;
        }
    }
    write("spoilt.exr", spoilt);
    write_exr(folder_ / "mask.exr", std::vector<ChannelView>{{"first", &other}, {"second", &left}}, {});
    EXPECT_EQ(compare("spoilt.exr --mask mask.exr").exit_code, 4);
    EXPECT_EQ(compared("spoilt.exr --mask mask.exr --mask-channel second")["valid_pixels"], 40 * kHeight);
}

}  // namespace
}  // namespace aoscore
