// What files say of their own values and pictures, beyond their pixels: codings of PNG, exposures of Radiance
// pictures, further pages.
#include "files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
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

TEST(StatedExposure, OfARadiancePictureIsTakenOff) {
    const auto path = output_dir() / "image.hdr";
    // Mantissas of 128 with an exponent of 128 are .5: what was .25 was multiplied by 2, then by 1.
    testing::write_bytes(path,
                         "#?RADIANCE\nEXPOSURE=2.0\nFORMAT=32-bit_rle_rgbe\nEXPOSURE= 1.0\n\n-Y 1 +X 1\n" +
                             std::string(4, '\x80'));
    // Half of the mantissa's last step is added by some readers.
    EXPECT_NEAR(read_visibility(path, kLinear).visibility.at(0, 0), 0.25, 0.5 / 256);
}

}  // namespace
}  // namespace aoscore
