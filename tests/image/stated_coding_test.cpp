// What files say of their own values, beyond their pixels: codings of PNG and DPX, scales of PFM, exposures
// of Radiance pictures, data windows of EXR.
#include "files.h"
#include "image/environment_file.h"
#include "image/image_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using testing::file_error_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kLinear;
using testing::kSrgb;
using testing::output_dir;

std::string big_endian(std::uint32_t number) {
    return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
            static_cast<char>(number)};
}

/// The checksum of a PNG's chunk, bit by bit (W3C, Portable Network Graphics Specification, annex D).
std::uint32_t checksum(const std::string& bytes) {
    std::uint32_t sum = 0xffffffff;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
    }
    return ~sum;
}

struct Chunk {
    std::string name, data;
};

/// A grey PNG of one pixel with chunks before its pixels.
std::filesystem::path png_with(const std::vector<Chunk>& chunks) {
    constexpr std::size_t kHeaderEnd = 8 + 25;  // the signature and the chunk IHDR
    std::string bytes = encode_png_gray(Image<std::uint8_t>(1, 1, 128)), inserted;
    for (const auto& [name, data] : chunks) {
        inserted += big_endian(static_cast<std::uint32_t>(data.size()));
        inserted += name + data + big_endian(checksum(name + data));
    }
    bytes.insert(kHeaderEnd, inserted);
    const auto path = output_dir() / "image.png";
    testing::write_bytes(path, bytes);
    return path;
}

/// Code points of H.273: primaries of BT.2020, a transfer characteristic, no matrix, and the range.
Chunk code_points(char transfer, bool full_range = true) {
    return {"cICP", std::string{'\x9', transfer, '\0', full_range ? '\1' : '\0'}};
}

const Chunk kSrgbChunk{"sRGB", std::string(1, '\0')}, kLinearGamma{"gAMA", big_endian(100000)},
    kSrgbGamma{"gAMA", big_endian(45455)}, kOtherGamma{"gAMA", big_endian(55556)};

TEST(StatedCoding, OfAPngThatContradictsTheOptionIsAWarningThatNamesTheOther) {
    const struct {
        std::vector<Chunk> chunks;
        const char *against_linear, *against_srgb;
    } files[] = {{{}, "", ""},
                 {{kSrgbChunk}, "chunk sRGB says that its values are sRGB-coded", ""},
                 {{kSrgbGamma}, "chunk gAMA says that its values are sRGB-coded", ""},
                 {{kLinearGamma}, "", "chunk gAMA says that its values are linear"},
                 {{kOtherGamma}, "", ""},
                 {{kLinearGamma, kSrgbChunk}, "chunk sRGB says that its values are sRGB-coded", ""}};
    for (const auto& file : files) {
        const auto path = png_with(file.chunks);
        for (const auto& [reading, said, option] : {std::tuple{kLinear, file.against_linear, "try --srgb"},
                                                    {kSrgb, file.against_srgb, "try --linear"}}) {
            const std::vector<std::string> warnings = read_visibility(path, reading).warnings;
            if (std::string_view(said).empty()) {
                EXPECT_THAT(warnings, IsEmpty());
            } else {
                EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr(said), HasSubstr(option))));
            }
        }
    }
}

TEST(StatedCoding, OfCodePointsIsHeldAboveAllElseAndNoOptionReadsOtherCurves) {
    const struct {
        char transfer;
        const char *against_linear, *against_srgb;
    } cases[] = {{8, "", "chunk cICP says that its values are linear"},
                 {13, "chunk cICP says that its values are sRGB-coded", ""},
                 {16, "coded by PQ", "coded by PQ"},
                 {18, "coded by HLG", "coded by HLG"},
                 {1, "the curve of video, BT.709", "the curve of video, BT.709"},
                 {6, "the curve of video, BT.601", "the curve of video, BT.601"},
                 {14, "the curve of video, BT.2020", "the curve of video, BT.2020"},
                 {15, "the curve of video, BT.2020", "the curve of video, BT.2020"},
                 {4, "a gamma of 2.2", "a gamma of 2.2"},
                 {9, "logarithmic", "logarithmic"},
                 {17, "the curve of cinema", "the curve of cinema"},
                 {2, "", ""}};
    for (const auto& [transfer, against_linear, against_srgb] : cases) {
        for (const Chunk& other : {kLinearGamma, kSrgbChunk}) {
            const auto path = png_with({code_points(transfer), other});
            for (const auto& [reading, said] :
                 {std::pair{kLinear, against_linear}, std::pair{kSrgb, against_srgb}}) {
                const std::vector<std::string> warnings = read_visibility(path, reading).warnings;
                if (std::string_view(said).empty()) {
                    EXPECT_THAT(warnings, IsEmpty()) << int{transfer};
                } else {
                    EXPECT_THAT(warnings, ElementsAre(HasSubstr(said))) << int{transfer};
                }
            }
        }
    }
}

TEST(StatedCoding, OfALimitedRangeIsAWarningWhateverTheCurveAndTheOption) {
    for (const char transfer : {1, 8, 13, 16}) {
        const auto path = png_with({code_points(transfer, false)});
        for (const auto& reading : {kLinear, kSrgb})
            EXPECT_THAT(read_visibility(path, reading).warnings, ElementsAre(HasSubstr("of limited range")));
    }
}

TEST(StatedCoding, OfAChunkOfAWrongSizeCountsAsNone) {
    for (const std::size_t size : {0, 2, 3, 5, 100}) {
        const Chunk malformed{"cICP", std::string(size, '\x10')};
        EXPECT_THAT(read_visibility(png_with({malformed}), kLinear).warnings, IsEmpty()) << size;
        EXPECT_THAT(read_visibility(png_with({malformed, kSrgbChunk}), kLinear).warnings,
                    ElementsAre(HasSubstr("chunk sRGB")))
            << size;
    }
}

/// A DPX of one grey pixel, 8 bits, by the fields that a reader needs (SMPTE 268M-2003).
std::filesystem::path dpx_with(char transfer) {
    std::string bytes(2048, '\0');
    const auto put = [&](std::size_t at, const std::string& field) {
        bytes.replace(at, field.size(), field);
    };
    put(0, "SDPX");
    put(4, big_endian(2048));  // where the pixels begin
    put(8, "V2.0");
    put(16, big_endian(2052));  // bytes of the file
    put(770, {'\0', '\1'});     // one element
    put(772, big_endian(1));
    put(776, big_endian(1));
    put(800, {'\x32', transfer, '\0', '\x8'});  // red, green and blue; 8 bits
    put(808, big_endian(2048));
    const auto path = output_dir() / "image.dpx";
    testing::write_bytes(path, bytes + std::string("\x80\x80\x80\0", 4));
    return path;
}

TEST(StatedCoding, OfADpxIsRefusedWhereItIsFilmAndAWarningWhereItIsVideo) {
    for (const char film : {1, 3}) {
        EXPECT_THAT(file_error_of([&] { read_visibility(dpx_with(film), kLinear); }),
                    AllOf(HasSubstr("not linear"), HasSubstr("a linear export")));
    }
    EXPECT_THAT(read_visibility(dpx_with(6), kLinear).warnings, ElementsAre(HasSubstr("the curve of video")));
    const VisibilityFile linear = read_visibility(dpx_with(2), kLinear);
    EXPECT_THAT(linear.warnings, IsEmpty());
    EXPECT_NEAR(linear.visibility.at(0, 0), 128 / 255.0, 1e-6);
}

TEST(StatedScale, OfAPfmIsAppliedAndSaid) {
    const auto path = output_dir() / "image.pfm";
    const std::string half = std::string("\0\0\0\x3f", 4);  // .5, little-endian
    testing::write_bytes(path, "Pf\n1 1\n-1.0\n" + half);
    EXPECT_THAT(read_visibility(path, kLinear).warnings, IsEmpty());
    testing::write_bytes(path, "Pf\n1 1\n-2.0\n" + half);
    const VisibilityFile scaled = read_visibility(path, kLinear);
    EXPECT_EQ(scaled.visibility.at(0, 0), 1);
    EXPECT_THAT(scaled.warnings, ElementsAre(HasSubstr("scale is 2, by which its values are multiplied")));
}

TEST(StatedScale, OfNothingOrNoNumberInAPfmIsRefused) {
    const auto path = output_dir() / "image.pfm";
    for (const std::string scale : {"0", "-0.0", "0.000", "nan", "inf"}) {
        testing::write_bytes(path, "Pf\n1 1\n" + scale + "\n" + std::string("\0\0\0\x3f", 4));
        EXPECT_THAT(file_error_of([&] { read_visibility(path, kLinear); }),
                    AllOf(HasSubstr("image.pfm"), HasSubstr("scale")))
            << scale;
    }
}

TEST(StatedCoding, IsNamedWhereNoOptionSaysWhich) {
    const auto path = png_with({kLinearGamma});
    try {
        read_visibility(path, {});
        ADD_FAILURE() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::usage);
        EXPECT_THAT(e.what(), HasSubstr("may be sRGB-coded or linear; its chunk gAMA says linear"));
    }
}

/// A Radiance picture of 1x1 pixels, every mantissa 128 with an exponent of 128, which is .5.
std::filesystem::path radiance_with(const std::string& lines) {
    const auto path = output_dir() / "image.hdr";
    testing::write_bytes(path, "#?RADIANCE\n" + lines + "\n-Y 1 +X 1\n" + std::string(4, '\x80'));
    return path;
}

// Half of the mantissa's last step is added by some readers.
constexpr double kHalfStep = 0.5 / 256;

TEST(StatedExposure, OfARadiancePictureIsTakenOff) {
    // What was .25 was multiplied by 2, then by 1.
    const auto path = radiance_with("EXPOSURE=2.0\nFORMAT=32-bit_rle_rgbe\nEXPOSURE= 1.0\n");
    EXPECT_NEAR(read_visibility(path, kLinear).visibility.at(0, 0), 0.25, kHalfStep);
}

TEST(StatedExposure, OfAColourCorrectionIsTakenOffByChannel) {
    const ImageFile file = read_image(
        radiance_with("FORMAT=32-bit_rle_rgbe\nCOLORCORR=1.0 2.0 4.0\nCOLORCORR=1 1 2\nEXPOSURE=2\n"));
    ASSERT_EQ(file.channels.size(), 3U);
    for (const auto& [channel, original] : {std::pair{0, 0.25}, std::pair{1, 0.125}, std::pair{2, 0.03125}})
        EXPECT_NEAR(file.channels[static_cast<std::size_t>(channel)].at(0, 0), original, kHalfStep);
}

TEST(StatedExposure, OfNothingIsRefusedByItsLine) {
    for (const std::string line : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=inf", "EXPOSURE=", "EXPOSURE=1 2",
                                   "COLORCORR=1 0 1", "COLORCORR=2"}) {
        const auto path = radiance_with("EXPOSURE=2\n" + line + "\nFORMAT=32-bit_rle_rgbe\n");
        EXPECT_THAT(file_error_of([&] { read_visibility(path, kLinear); }),
                    HasSubstr("its header says " + line + ","));
    }
}

TEST(StatedExposure, OfAGammaIsAWarning) {
    const auto path = radiance_with("GAMMA=2.2\nFORMAT=32-bit_rle_rgbe\n");
    EXPECT_THAT(read_visibility(path, kLinear).warnings, ElementsAre(HasSubstr("GAMMA=2.2")));
}

TEST(StatedColours, OfCieInARadiancePictureAreRefusedByName) {
    const auto path = radiance_with("FORMAT=32-bit_rle_xyze\n");
    EXPECT_THAT(file_error_of([&] { read_visibility(path, kLinear); }),
                AllOf(HasSubstr("CIE colours (XYZE)"), HasSubstr("32-bit_rle_rgbe")));
}

TEST(DataWindow, OfAPartIsNamedWhereAWholeFrameIsNeeded) {
    ImageFile file;
    file.width = 8;
    file.height = 4;
    file.covered = {{0, 0, 8, 4}, {1, 2, 3, 2}};
    EXPECT_NO_THROW(require_whole_frame(file, 0, "a file"));
    EXPECT_THAT(file_error_of([&] { require_whole_frame(file, 1, "a file"); }),
                HasSubstr("holds 3x2 pixels at 1, 2 of its 8x4: its data window"));
}

}  // namespace
}  // namespace aoscore
