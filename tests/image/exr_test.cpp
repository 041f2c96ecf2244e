#include "core/threads.h"
#include "files.h"

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::random_bits;
using testing::same_bits;

TEST(Exr, ComesBackBitByBitWithNamesAndAttributes) {
    const auto path = output_dir() / "truth.exr";
    const ImageF y = random_bits(301, 77, 1), se = random_bits(301, 77, 2), n = random_bits(301, 77, 3);
    const std::vector<ChannelView> channels = {{"Y", &y}, {"SE.Y", &se}, {"N.X", &n}};
    const std::string matrix = "1 0 0 0 0 0.5 0 0 0 0 -1 0 3 4 5.25 1";
    write_exr(path, channels,
              {{"aoscore:seed", "1"},
               {"aoscore:note", "long " + std::string(5000, 'x') + " ä"},
               {"worldToCamera", matrix},
               {"comments", "by hand"}});
    const ImageFile file = read_image(path);
    EXPECT_EQ(file.width, 301);
    EXPECT_EQ(file.height, 77);
    EXPECT_EQ(file.channels.size(), 3U);
    EXPECT_FALSE(file.integers);
    for (const ChannelView& channel : channels) {
        ASSERT_NE(file.channel(channel.name), nullptr) << channel.name;
        EXPECT_TRUE(same_bits(*file.channel(channel.name), *channel.image)) << channel.name;
    }
    EXPECT_EQ(file.channel("Z"), nullptr);
    EXPECT_EQ(file.attributes.at("aoscore:seed"), "1");
    EXPECT_EQ(file.attributes.at("aoscore:note"), "long " + std::string(5000, 'x') + " ä");
    EXPECT_EQ(file.attributes.at("worldToCamera"), matrix);
    EXPECT_EQ(file.attributes.at("comments"), "by hand");
}

Imf::Compression compression_of(const std::filesystem::path& path) {
    return Imf::InputFile(path.c_str()).header().compression();
}

TEST(Exr, IsPackedWhereThatTakesAThirdOff) {
    const auto noisy = output_dir() / "noisy.exr", smooth = output_dir() / "smooth.exr";
    const ImageF noise = testing::random_visibility(320, 200, 1);
    ImageF levels(320, 200);
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 320; ++x) levels.at(x, y) = static_cast<float>((x + y) / 8) / 255;
    }
    write_exr(noisy, std::vector<ChannelView>{{"Y", &noise}}, {});
    write_exr(smooth, std::vector<ChannelView>{{"Y", &levels}}, {});
    EXPECT_EQ(compression_of(noisy), Imf::NO_COMPRESSION);
    EXPECT_EQ(compression_of(smooth), Imf::ZIP_COMPRESSION);
    EXPECT_LT(std::filesystem::file_size(smooth), levels.size() * sizeof(float) * 2 / 3);
    EXPECT_TRUE(same_bits(*read_image(noisy).channel("Y"), noise));
    EXPECT_TRUE(same_bits(*read_image(smooth).channel("Y"), levels));
}

TEST(Exr, IsTheSameFileForAnyNumberOfThreads) {
    const auto folder = output_dir();
    const ImageF y = testing::random_visibility(640, 300, 1);
    const std::vector<ChannelView> channels = {{"Y", &y}};
    set_thread_count(1);
    write_exr(folder / "one.exr", channels, {});
    set_thread_count(4);
    write_exr(folder / "four.exr", channels, {});
    set_thread_count(0);
    EXPECT_EQ(read_file(folder / "one.exr"), read_file(folder / "four.exr"));
}

TEST(Exr, IsOldOrNewButNeverHalfWhenTheDiskIsFull) {
    const auto folder = output_dir();
    const auto path = folder / "image.exr";
    const ImageF old = testing::random_visibility(8, 8, 1), large = random_bits(400, 400, 2);
    write_exr(path, std::vector<ChannelView>{{"Y", &old}}, {});

    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit small{100'000, unlimited.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = testing::file_error_of([&] {
        write_exr(path, std::vector<ChannelView>{{"Y", &large}}, {});
    });
    setrlimit(RLIMIT_FSIZE, &unlimited);
    std::signal(SIGXFSZ, handler);

    EXPECT_THAT(message, HasSubstr("image.exr"));
    EXPECT_TRUE(same_bits(*read_image(path).channel("Y"), old));
    EXPECT_EQ(testing::files_in(folder), 1U);
}

TEST(Exr, PathThatCannotBeWrittenIsAnErrorThatNamesIt) {
    const auto folder = output_dir();
    testing::write_bytes(folder / "file", "x");
    std::filesystem::create_directories(folder / "taken.exr" / "inside");
    const ImageF y(4, 4);
    const std::vector<ChannelView> channels = {{"Y", &y}};
    EXPECT_THAT(testing::file_error_of([&] { write_exr(folder / "file" / "y.exr", channels, {}); }),
                HasSubstr("/file"));
    EXPECT_THAT(testing::file_error_of([&] { write_exr(folder / "taken.exr", channels, {}); }),
                HasSubstr("taken.exr"));
    EXPECT_EQ(testing::files_in(folder), 2U);
}

TEST(Exr, ChannelsThatDoNotFitAreADefectAndWriteNothing) {
    const auto folder = output_dir();
    const ImageF small(4, 4), large(8, 8), none;
    for (const std::vector<ChannelView>& channels : std::vector<std::vector<ChannelView>>{
             {}, {{"Y", &none}}, {{"Y", &small}, {"Z", &large}}, {{"Y", &small}, {"Y", &small}}}) {
        EXPECT_THROW(write_exr(folder / "y.exr", channels, {}), Error);
    }
    const std::vector<ChannelView> channels = {{"Y", &small}};
    EXPECT_THROW(write_exr(folder / "y.exr", channels, {{"compression", "none"}}), Error);
    EXPECT_THROW(write_exr(folder / "y.exr", channels, {{"worldToNDC", "1 2 3"}}), Error);
    EXPECT_EQ(testing::files_in(folder), 0U);
}

}  // namespace
}  // namespace aoscore
