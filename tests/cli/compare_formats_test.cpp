// `aoscore compare` with TIFF and HDR, written here byte by byte after their specifications (Adobe, TIFF,
// revision 6.0, 1992; Greg Ward, Real Pixels, in Graphics Gems II, 1991).
#include "core/files.h"
#include "image/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

namespace aoscore {
namespace {

using nlohmann::json;
using testing::output_dir;
using testing::run_aoscore;

constexpr int kWidth = 40, kHeight = 24;

/// An image that changes when turned upside down or inverted, within [0.05, 0.95].
ImageF truth_image() {
    ImageF image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x)
            image.at(x, y) = 0.05F + 0.5F * static_cast<float>(x) / kWidth +
                             0.4F * static_cast<float>(y * y) / (kHeight * kHeight);
    }
    return image;
}

void append(std::string& bytes, std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

enum class SampleFormat : std::uint64_t { unsigned_integer = 1, floating = 3 };

/// A little-endian gray TIFF of one strip.
std::string tiff(const ImageF& image, int bytes_per_sample, SampleFormat format) {
    std::string strip;
    const double white = std::pow(2, 8 * bytes_per_sample) - 1;
    for (const float value : image.pixels) {
        append(strip,
               format == SampleFormat::floating ? std::bit_cast<std::uint32_t>(value)
                                                : static_cast<std::uint64_t>(std::lround(value * white)),
               bytes_per_sample);
    }
    enum Type : std::uint64_t { kShort = 3, kLong = 4 };
    const std::vector<std::array<std::uint64_t, 3>> entries = {
        {256, kLong, static_cast<std::uint64_t>(image.width)},
        {257, kLong, static_cast<std::uint64_t>(image.height)},
        {258, kShort, static_cast<std::uint64_t>(8 * bytes_per_sample)},
        {259, kShort, 1},  // no compression
        {262, kShort, 1},  // 0 is black
        {273, kLong, 8},   // the strip begins after the header
        {277, kShort, 1},
        {278, kLong, static_cast<std::uint64_t>(image.height)},
        {279, kLong, strip.size()},
        {339, kShort, static_cast<std::uint64_t>(format)}};
    std::string bytes = "II";
    append(bytes, 42, 2);
    append(bytes, 8 + strip.size(), 4);
    bytes += strip;
    append(bytes, entries.size(), 2);
    for (const auto& [tag, type, value] : entries) {
        append(bytes, tag, 2);
        append(bytes, type, 2);
        append(bytes, 1, 4);
        append(bytes, value, 4);
    }
    append(bytes, 0, 4);
    return bytes;
}

/// Appends a page to a TIFF: the first page's directory once more.
std::string with_further_page(std::string bytes) {
    const auto number = [&](std::size_t at, int count) {
        std::size_t value = 0;
        for (int i = 0; i < count; ++i)
            value |= std::size_t{static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)])}
                     << (8 * i);
        return value;
    };
    const std::size_t directory = number(4, 4), next = directory + 2 + 12 * number(directory, 2);
    const std::string copy = bytes.substr(directory);
    std::string offset;
    append(offset, bytes.size(), 4);
    return bytes.replace(next, 4, offset) + copy;
}

/// Radiance's pixels without compression: three mantissas and one exponent each.
std::string hdr(const ImageF& image) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " +
                        std::to_string(image.width) + "\n";
    for (const float value : image.pixels) {
        int exponent = 0;
        const double mantissa = std::frexp(static_cast<double>(value), &exponent);
        const auto level = static_cast<char>(static_cast<unsigned char>(std::min(255.0, mantissa * 256)));
        bytes += {level, level, level, static_cast<char>(exponent + 128)};
    }
    return bytes;
}

ImageF image_of(const std::function<float(int x, int y)>& value_at, int width = kWidth,
                int height = kHeight) {
    ImageF result(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) result.at(x, y) = value_at(x, y);
    }
    return result;
}

float srgb_coded(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

struct Format {
    const char* name;
    const char* extension;
    std::string (*encode)(const ImageF&);
    bool integers;  ///< whether the coding must be stated
    double step;    ///< the largest error of a stored number
};

class CompareFormats : public ::testing::TestWithParam<Format> {
  protected:
    std::filesystem::path folder_ = output_dir();
    ImageF truth_ = truth_image();

    void SetUp() override { write_exr(folder_ / "truth.exr", std::vector<ChannelView>{{"Y", &truth_}}, {}); }

    std::string write(const std::string& name, const ImageF& image) {
        const std::string file = name + GetParam().extension;
        write_atomically(folder_ / file, GetParam().encode(image));
        return file;
    }
    double max_error(const std::string& arguments) {
        const auto run = run_aoscore("compare truth.exr " + arguments + " --json -", folder_);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const json result = json::parse(run.out, nullptr, false);
        return result.is_discarded() ? -1 : result["metrics"]["max_error"]["value"].get<double>();
    }
    double step() const { return GetParam().step; }
};

TEST_P(CompareFormats, HoldsTheTruthWithinAStep) {
    const std::string file = write("same", truth_);
    const double error = max_error(file + " --linear");
    EXPECT_GE(error, 0);
    EXPECT_LE(error, step());
}

TEST_P(CompareFormats, FlipsInvertsAndCrops) {
    const std::string flipped =
        write("flipped", image_of([&](int x, int y) { return truth_.at(x, kHeight - 1 - y); }));
    EXPECT_GT(max_error(flipped + " --linear"), 0.2);
    EXPECT_LE(max_error(flipped + " --linear --flip"), step());
    const std::string occlusion =
        write("occlusion", image_of([&](int x, int y) { return 1 - truth_.at(x, y); }));
    EXPECT_GT(max_error(occlusion + " --linear"), 0.2);
    EXPECT_LE(max_error(occlusion + " --linear --invert"), step());
    const std::string part =
        write("part", image_of([&](int x, int y) { return truth_.at(x + 5, y + 7); }, 20, 10));
    EXPECT_EQ(run_aoscore("compare truth.exr " + part + " --linear", folder_).exit_code, 3);
    EXPECT_LE(max_error(part + " --linear --crop 5,7,20,10"), step());
    const std::string all = write("all", image_of([&](int x, int y) {
                                      const bool upside_down = y >= kHeight - 17 && y < kHeight - 7;
                                      return upside_down ? 1 - truth_.at(x, kHeight - 1 - y) : 0.5F;
                                  }));
    EXPECT_LE(max_error(all + " --linear --invert --flip --crop 5,7,20,10"), step());
}

TEST_P(CompareFormats, IntegersHaveToSayTheirCodingAndFloatsAreLinear) {
    const std::string linear = write("linear", truth_);
    const auto silent = run_aoscore("compare truth.exr " + linear, folder_);
    const std::string coded =
        write("coded", image_of([&](int x, int y) { return srgb_coded(truth_.at(x, y)); }));
    if (GetParam().integers) {
        EXPECT_EQ(silent.exit_code, 64);
        EXPECT_THAT(silent.err, ::testing::HasSubstr("--srgb"));
        EXPECT_GT(max_error(coded + " --linear"), 0.1);
        EXPECT_LE(max_error(coded + " --srgb"), 2.4 * step()) << "the steepest part of the curve";
    } else {
        EXPECT_EQ(silent.exit_code, 0);
        EXPECT_LE(max_error(linear + " --srgb"), step());
    }
}

TEST(FurtherPages, OfATiffAreNotLookedAtAndThatIsSaid) {
    const auto folder = output_dir();
    const ImageF truth = truth_image();
    write_exr(folder / "truth.exr", std::vector<ChannelView>{{"Y", &truth}}, {});
    const std::string one = tiff(truth, 4, SampleFormat::floating);
    write_atomically(folder / "one.tif", one);
    write_atomically(folder / "two.tif", with_further_page(one));
    EXPECT_EQ(run_aoscore("compare truth.exr one.tif", folder).err, "");
    const auto run = run_aoscore("compare truth.exr two.tif --fail 'max_error>1e-6'", folder);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.err, ::testing::HasSubstr("not looked at: the file's further pages"));
}

INSTANTIATE_TEST_SUITE_P(
    Files, CompareFormats,
    ::testing::Values(Format{"TiffOf8Bits", ".tif",
                             [](const ImageF& i) { return tiff(i, 1, SampleFormat::unsigned_integer); }, true,
                             0.501 / 255},
                      Format{"TiffOf16Bits", ".tif",
                             [](const ImageF& i) { return tiff(i, 2, SampleFormat::unsigned_integer); }, true,
                             0.51 / 65535},
                      Format{"TiffOfFloats", ".tif",
                             [](const ImageF& i) { return tiff(i, 4, SampleFormat::floating); }, false, 1e-6},
                      Format{"RadianceHdr", ".hdr", hdr, false, 1.01 / 256}),
    [](const auto& format) { return format.param.name; });

}  // namespace
}  // namespace aoscore
