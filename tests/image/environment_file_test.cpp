#include "image/environment_file.h"

#include "core/error.h"
#include "core/files.h"
#include "image/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;

std::filesystem::path file_of(const ImageF& red, const ImageF& green, const ImageF& blue) {
    const auto path = output_dir() / "environment.exr";
    const std::vector<ChannelView> channels{{"R", &red}, {"G", &green}, {"B", &blue}};
    write_exr(path, channels, {});
    return path;
}

std::string refusal(const ImageF& plane) {
    try {
        read_environment(file_of(plane, plane, plane), 0);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        return e.what();
    }
    return "accepted";
}

ImageF with(float value) {
    ImageF plane(8, 4, 1);
    plane.at(3, 2) = value;
    return plane;
}

TEST(EnvironmentFile, IsReadWithItsColoursWhereTheyLie) {
    ImageF red(8, 4, 0.5F), green(8, 4, 1), blue(8, 4, 2);
    red.at(4, 1) = 7;  // right of the middle, above the horizon
    const Environment light = read_environment(file_of(red, green, blue), 0);
    EXPECT_EQ(light.id(), "environment.exr");
    const double around = 2 * std::acos(-1.0) / 16, above = std::acos(-1.0) / 8;
    const glm::dvec3 from(std::cos(above) * std::cos(around), std::sin(above),
                          std::cos(above) * std::sin(around));
    EXPECT_EQ(light.radiance(from), glm::dvec3(7, 1, 2));
    EXPECT_EQ(light.radiance({from.x, from.y, -from.z}), glm::dvec3(0.5, 1, 2)) << "not mirrored";
    EXPECT_EQ(light.radiance({from.x, -from.y, from.z}), glm::dvec3(0.5, 1, 2)) << "not upside down";
}

TEST(EnvironmentFile, MayBeTurned) {
    const ImageF plane(8, 4, 1);
    EXPECT_THAT(read_environment(file_of(plane, plane, plane), 90).id(), HasSubstr("turned by 90°"));
}

TEST(EnvironmentFile, OfOneChannelIsGray) {
    const ImageF plane(2, 1, 3);
    const auto path = output_dir() / "gray.exr";
    write_exr(path, std::vector<ChannelView>{{"Y", &plane}}, {});
    EXPECT_EQ(read_environment(path, 0).radiance({0, 1, 0}), glm::dvec3(3));
}

TEST(EnvironmentFile, IsNotDarkerForWhatCompressionLeavesBelowZero) {
    const ImageF plane = with(-0.01F);
    const Environment light = read_environment(file_of(plane, plane, plane), 0);
    for (const glm::vec3& texel : light.map()->radiance.pixels)
        EXPECT_TRUE(texel == glm::vec3(1) || texel == glm::vec3(0)) << texel.x;
}

TEST(EnvironmentFile, IsRefusedWhereItCannotBeLight) {
    EXPECT_THAT(refusal(ImageF(8, 8, 1)), HasSubstr("twice as wide as high"));
    EXPECT_THAT(refusal(ImageF(8, 4, 0)), HasSubstr("black everywhere"));
    EXPECT_THAT(refusal(with(-0.5F)), HasSubstr("is -0.5 at pixel 3, 2"));
    EXPECT_THAT(refusal(with(std::numeric_limits<float>::quiet_NaN())), HasSubstr("nan at pixel 3, 2"));
    EXPECT_THAT(refusal(with(std::numeric_limits<float>::infinity())), HasSubstr("inf at pixel 3, 2"));
    EXPECT_EQ(refusal(with(1e5F)), "accepted");
    const ImageF plane(8, 4, 1);
    const auto path = output_dir() / "depth.exr";
    write_exr(path, std::vector<ChannelView>{{"Z", &plane}}, {});
    EXPECT_THROW(read_environment(path, 0), Error);
}

TEST(EnvironmentFile, OfIntegersIsRefused) {
    const auto path = output_dir() / "environment.png";
    write_atomically(path, encode_png_gray(Image<std::uint8_t>(8, 4, 200)));
    try {
        read_environment(path, 0);
        FAIL() << "accepted";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), HasSubstr("integers"));
    }
}

}  // namespace
}  // namespace aoscore
