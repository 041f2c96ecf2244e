// Tests `aoscore compare`: its JSON object, gates, and the usual mistakes of comparing tools.
#include "core/files.h"
#include "image/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

using nlohmann::json;
using testing::output_dir;
using testing::run_aoscore;

constexpr int kSide = 64;

ImageF ramp() {
    ImageF image(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) image.at(x, y) = static_cast<float>(x) / kSide;
    }
    return image;
}

void write(const std::filesystem::path& path, const ImageF& image, const ImageF* mask = nullptr) {
    std::vector<ChannelView> channels{{"Y", &image}};
    if (mask != nullptr) channels.push_back({"mask.Y", mask});
    write_exr(path, channels, {});
}

class Compare : public ::testing::Test {
  protected:
    std::filesystem::path folder_ = output_dir();

    json compare(const std::string& arguments, int expected_exit) {
        const auto run = run_aoscore("compare " + arguments + " --json -", folder_);
        EXPECT_EQ(run.exit_code, expected_exit) << run.err;
        return json::parse(run.out, nullptr, false);
    }
};

TEST_F(Compare, IdenticalImagesHaveNoErrorAndAPsnrOfNullWithANote) {
    write(folder_ / "a.exr", ramp());
    const json result = compare("a.exr a.exr", 0);
    EXPECT_EQ(result["metrics"]["rmse"]["value"], 0.0);
    EXPECT_TRUE(result["metrics"]["psnr"]["value"].is_null());
    EXPECT_FALSE(result["metrics"]["psnr"]["note"].get<std::string>().empty());
    EXPECT_EQ(result["valid_pixels"], kSide * kSide);
    EXPECT_EQ(result["nonfinite"], 0);
    for (const char* id : {"mae", "rmse", "bias", "psnr", "ssim", "max_error"}) {
        EXPECT_TRUE(result["metrics"].contains(id)) << id;
    }
}

TEST_F(Compare, AThresholdOf0IsOfAllDifferencesAndSaysSoWhereTheTruthHasNoise) {
    ImageF noisy = ramp(), error(kSide, kSide, 0.05F);
    for (std::size_t i = 0; i < noisy.size(); ++i) noisy.pixels[i] += i % 2 == 0 ? 0.05F : -0.05F;
    write(folder_ / "exact.exr", ramp());
    write_exr(folder_ / "noisy.exr", std::vector<ChannelView>{{"Y", &noisy}, {"SE.Y", &error}}, {});
    const auto warned = [](const json& result) { return result["warnings"].dump(); };
    const json at_0 = compare("noisy.exr exact.exr --mask-threshold 0", 0);
    EXPECT_THAT(warned(at_0), ::testing::HasSubstr("every difference counts, also one by the truth's noise"));
    EXPECT_NEAR(at_0["masks"]["missing_area"].get<double>() + at_0["masks"]["false_area"].get<double>(), 1,
                1e-9);
    for (const char* arguments : {"noisy.exr exact.exr", "exact.exr noisy.exr --mask-threshold 0"})
        EXPECT_THAT(warned(compare(arguments, 0)), ::testing::Not(::testing::HasSubstr("every difference")));
}

TEST_F(Compare, BiasIsTestMinusTruthSoSwappingTurnsItsSign) {
    ImageF brighter = ramp();
    for (float& value : brighter.pixels) value += 0.125f;
    write(folder_ / "truth.exr", ramp());
    write(folder_ / "test.exr", brighter);
    EXPECT_NEAR(compare("truth.exr test.exr", 0)["metrics"]["bias"]["value"].get<double>(), 0.125, 1e-6);
    EXPECT_NEAR(compare("test.exr truth.exr", 0)["metrics"]["bias"]["value"].get<double>(), -0.125, 1e-6);
}

TEST_F(Compare, SizesThatDifferExitWith3) {
    write(folder_ / "a.exr", ramp());
    write(folder_ / "b.exr", ImageF(kSide, kSide + 1));
    EXPECT_EQ(run_aoscore("compare a.exr b.exr", folder_).exit_code, 3);
}

TEST_F(Compare, NotANumberAgainstAnythingNeverPasses) {
    write(folder_ / "half.exr", ImageF(kSide, kSide, 0.5f));
    write(folder_ / "nan.exr", ImageF(kSide, kSide, std::numeric_limits<float>::quiet_NaN()));
    const json result = compare("half.exr nan.exr", 2);
    EXPECT_EQ(result["nonfinite"], kSide * kSide);
    EXPECT_TRUE(result["metrics"]["rmse"]["value"].is_null());
    EXPECT_EQ(run_aoscore("compare nan.exr half.exr", folder_).exit_code, 2);
}

TEST_F(Compare, AMaskThatCoversEverythingNeverPasses) {
    const ImageF nothing(kSide, kSide, 0.0f);
    write(folder_ / "a.exr", ramp(), &nothing);
    const json result = compare("a.exr a.exr", 2);
    EXPECT_EQ(result["valid_pixels"], 0);
    EXPECT_TRUE(result["metrics"]["ssim"]["value"].is_null());
}

TEST_F(Compare, AnAllBlackTruthIsNoExcuse) {
    write(folder_ / "black.exr", ImageF(kSide, kSide, 0.0f));
    write(folder_ / "a.exr", ramp());
    EXPECT_GT(compare("black.exr a.exr", 0)["metrics"]["rmse"]["value"].get<double>(), 0.5);
}

TEST_F(Compare, MaskedPixelsDoNotCount) {
    ImageF mask(kSide, kSide, 1.0f), spoilt = ramp();
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide / 2; ++x) {
            mask.at(x, y) = 0;
            spoilt.at(x, y) = 1;
        }
    }
    write(folder_ / "truth.exr", ramp(), &mask);
    write(folder_ / "test.exr", spoilt);
    const json result = compare("truth.exr test.exr", 0);
    EXPECT_EQ(result["metrics"]["rmse"]["value"], 0.0);
    EXPECT_EQ(result["metrics"]["max_error"]["value"], 0.0);
    EXPECT_EQ(result["valid_pixels"], kSide * kSide / 2);
}

// The values that scikit-image gives (gaussian_weights, sigma 1.5, use_sample_covariance False, data_range
// 1).
TEST_F(Compare, EightBitImagesReproduceTheKnownSsimAndRmse) {
    struct Case {
        const char* name;
        int (*truth)(int x, int y);
        int (*test)(int x, int y);
        double ssim, rmse;
    };
    const Case cases[] = {
        {"stripes", [](int x, int y) { return (7 * x + 13 * y) % 256; },
         [](int x, int y) { return (7 * x + 13 * y) % 256 * 9 / 10 + 12; }, .993096247, .029195},
        {"ramp", [](int x, int) { return 4 * x; }, [](int x, int) { return std::max(4 * x - 25, 0); },
         .888906189, .094394},
        {"const", [](int, int) { return 128; }, [](int, int) { return 138; }, .997177892, .039216},
    };
    for (const Case& c : cases) {
        const auto write_png = [&](const char* role, int (*value)(int, int)) {
            Image<std::uint8_t> image(kSide, kSide);
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) image.at(x, y) = static_cast<std::uint8_t>(value(x, y));
            }
            const std::string name = std::string(c.name) + role + ".png";
            write_atomically(folder_ / name, encode_png_gray(image));
            return name;
        };
        const json result =
            compare(write_png("-truth", c.truth) + " " + write_png("-test", c.test) + " --linear", 0);
        EXPECT_NEAR(result["metrics"]["ssim"]["value"].get<double>(), c.ssim, 1e-6) << c.name;
        EXPECT_NEAR(result["metrics"]["rmse"]["value"].get<double>(), c.rmse, 1e-6) << c.name;
    }
}

TEST_F(Compare, GatesDecideTheExitCode) {
    ImageF brighter = ramp();
    for (float& value : brighter.pixels) value += 0.05f;
    write(folder_ / "truth.exr", ramp());
    write(folder_ / "test.exr", brighter);
    EXPECT_EQ(run_aoscore("compare truth.exr test.exr --fail 'rmse>0.06'", folder_).exit_code, 0);
    const auto failed = run_aoscore("compare truth.exr test.exr --fail 'rmse>0.02' --warn 'ssim<1'", folder_);
    EXPECT_EQ(failed.exit_code, 2);
    EXPECT_THAT(failed.err, ::testing::HasSubstr("rmse is 0.05"));
    EXPECT_EQ(run_aoscore("compare truth.exr test.exr --warn 'rmse>0.02'", folder_).exit_code, 1);
}

TEST_F(Compare, EightBitFilesHaveToSayHowTheyAreCoded) {
    Image<std::uint8_t> levels(kSide, kSide);
    for (std::size_t i = 0; i < levels.size(); ++i) levels.pixels[i] = static_cast<std::uint8_t>(i % 256);
    write_atomically(folder_ / "a.png", encode_png_gray(levels));
    const auto silent = run_aoscore("compare a.png a.png", folder_);
    EXPECT_EQ(silent.exit_code, 64);
    EXPECT_THAT(silent.err, ::testing::HasSubstr("--srgb"));
    EXPECT_THAT(silent.err, ::testing::HasSubstr("--linear"));
    ImageF linear(kSide, kSide), decoded(kSide, kSide);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double coded = levels.pixels[i] / 255.0;
        linear.pixels[i] = static_cast<float>(coded);
        decoded.pixels[i] =
            static_cast<float>(coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4));
    }
    write(folder_ / "linear.exr", linear);
    write(folder_ / "decoded.exr", decoded);
    EXPECT_LT(compare("linear.exr a.png --linear", 0)["metrics"]["rmse"]["value"].get<double>(), 1e-6);
    EXPECT_LT(compare("decoded.exr a.png --srgb", 0)["metrics"]["rmse"]["value"].get<double>(), 1e-6);
    EXPECT_EQ(run_aoscore("compare a.png a.png --srgb --linear", folder_).exit_code, 64);
}

TEST_F(Compare, FlipInvertCropChannelAndMaskUndoWhatTheyName) {
    ImageF truth = ramp(), upside_down(kSide, kSide), occlusion(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) truth.at(x, y) += static_cast<float>(y) / 256.0F;
    }
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            upside_down.at(x, kSide - 1 - y) = truth.at(x, y);
            occlusion.at(x, y) = 1 - truth.at(x, y);
        }
    }
    ImageF part(20, 10), spoilt = truth, left(kSide, kSide);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 20; ++x) part.at(x, y) = truth.at(x + 7, y + 30);
    }
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            left.at(x, y) = x < 40 ? 1.0F : 0.0F;
            if (x >= 40) spoilt.at(x, y) = 0;
        }
    }
    write(folder_ / "truth.exr", truth);
    write(folder_ / "flipped.exr", upside_down);
    write(folder_ / "occlusion.exr", occlusion);
    write(folder_ / "part.exr", part);
    write(folder_ / "spoilt.exr", spoilt);
    write(folder_ / "left.exr", left);
    const ImageF other(kSide, kSide, 0.5F);
    write_exr(folder_ / "engine.exr",
              std::vector<ChannelView>{{"ViewLayer.AO.R", &truth},
                                       {"ViewLayer.AO.G", &truth},
                                       {"ViewLayer.Depth.Z", &other},
                                       {"ViewLayer.Mine.V", &other}},
              {});
    const auto error = [&](const std::string& arguments) {
        return compare("truth.exr " + arguments, 0)["metrics"]["max_error"]["value"].get<double>();
    };
    EXPECT_GT(error("flipped.exr"), 0.2);
    EXPECT_EQ(error("flipped.exr --flip"), 0);
    EXPECT_GT(error("occlusion.exr"), 0.5);
    EXPECT_LT(error("occlusion.exr --invert"), 1e-6);
    EXPECT_EQ(error("part.exr --crop 7,30,20,10"), 0) << "a test that is cropped already";
    EXPECT_EQ(error("spoilt.exr --crop 7,30,20,10"), 0) << "a test of the whole size";
    EXPECT_EQ(run_aoscore("compare truth.exr part.exr", folder_).exit_code, 3);
    EXPECT_EQ(run_aoscore("compare truth.exr part.exr --crop 60,30,20,10", folder_).exit_code, 64);
    EXPECT_EQ(run_aoscore("compare truth.exr part.exr --crop 1,2,3", folder_).exit_code, 64);
    EXPECT_GT(error("spoilt.exr"), 0.5);
    EXPECT_EQ(error("spoilt.exr --mask left.exr"), 0);
    EXPECT_EQ(error("engine.exr"), 0) << "the layer called AO is found";
    EXPECT_GT(error("engine.exr --channel ViewLayer.Mine.V"), 0.3);
    EXPECT_EQ(run_aoscore("compare truth.exr engine.exr --channel nonsense", folder_).exit_code, 4);
}

TEST_F(Compare, AgreesWithIdiff) {
    ImageF test = ramp();
    for (std::size_t i = 0; i < test.size(); ++i) test.pixels[i] += 0.07F * std::sin(static_cast<float>(i));
    write(folder_ / "truth.exr", ramp());
    write(folder_ / "test.exr", test);
    const std::string command =
        "cd '" + folder_.string() + "' && idiff truth.exr test.exr >idiff.txt 2>idiff.log; test $? -ne 127";
    if (std::system(command.c_str()) != 0) GTEST_SKIP() << "idiff is not there (Debian: openimageio-tools)";
    const std::string said = read_file(folder_ / "idiff.txt");
    const auto number = [&](const std::string& name) {
        const auto at = said.find(name + " = ");
        return at == std::string::npos ? -1.0 : std::stod(said.substr(at + name.size() + 3));
    };
    const json metrics = compare("truth.exr test.exr", 0)["metrics"];
    EXPECT_NEAR(metrics["mae"]["value"].get<double>(), number("Mean error"), 1e-6) << said;
    EXPECT_NEAR(metrics["rmse"]["value"].get<double>(), number("RMS error"), 1e-6);
    // OIIO's PSNR is for the brightest value of the images, not for 1; "Max error" is followed by two blanks.
    EXPECT_NEAR(metrics["max_error"]["value"].get<double>(), number("Max error "), 1e-6);
}

}  // namespace
}  // namespace aoscore
