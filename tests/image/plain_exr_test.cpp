#include "image/plain_exr.h"

#include "files.h"
#include "image/image_formats.h"
#include "support/foreign_exr.h"

#include <ImfOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <half.h>

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

using testing::output_dir;
using testing::random_bits;
using testing::random_visibility;
using testing::same_bits;

/// All but the attributes that a plain reading leaves out.
void expect_same(const ImageFile& plain, const ImageFile& other, const fs::path& path) {
    EXPECT_EQ(plain.channel_names, other.channel_names) << path;
    EXPECT_EQ(plain.covered, other.covered) << path;
    EXPECT_EQ(plain.left_out, other.left_out) << path;
    EXPECT_EQ(std::tie(plain.width, plain.height, plain.integers),
              std::tie(other.width, other.height, other.integers))
        << path;
    ASSERT_EQ(plain.channels.size(), other.channels.size()) << path;
    for (std::size_t c = 0; c < plain.channels.size(); ++c)
        EXPECT_TRUE(same_bits(plain.channels[c], other.channels[c])) << path << plain.channel_names[c];
    for (const auto& [name, value] : plain.attributes) {
        ASSERT_TRUE(other.attributes.contains(name)) << path << name;
        EXPECT_EQ(other.attributes.at(name), value) << path;
    }
}

TEST(PlainExr, IsReadAsOpenImageIOReadsIt) {
    const fs::path path = output_dir() / "own.exr";
    std::vector<ImageF> images;
    std::vector<ChannelView> channels;
    const std::vector<std::string> names{"Y",     "SE.Y",   "mask.Y", "P.X", "P.Y",   "P.Z", "AO.R",
                                         "AO.G",  "AO.B",   "AO.A",   "Z",   "A-O.Y", "A.Y", "a.b.Y",
                                         "AO2.R", "left.Z", "R",      "G",   "B"};
    for (const std::string& name : names)
        images.push_back(random_bits(70, 41, static_cast<unsigned>(name.size())));
    for (std::size_t i = 0; i < names.size(); ++i) channels.push_back({names[i], &images[i]});
    write_exr(path, channels,
              {{"aoscore:seed", "1"},
               {"comments", "by hand"},
               {"worldToCamera", "1 0 0 0 0 0.5 0 0 0 0 1e-07 0 3 4 5 1"}});
    const std::optional<ImageFile> plain = read_plain_exr(path);
    ASSERT_TRUE(plain);
    EXPECT_THAT(plain->attributes, ::testing::Contains(::testing::Pair("aoscore:seed", "1")));
    EXPECT_TRUE(plain->attributes.contains("worldToCamera"));
    expect_same(*plain, image_formats().read(path), path);
}

TEST(PlainExr, ListsTheComponentsOfALayerAsOpenImageIODoes) {
    const fs::path folder = output_dir();
    const ImageF image = random_visibility(3, 2, 1);
    const std::string components = "RGBAXYZ";
    for (const std::string layer : {"", "AO.", "P."}) {
        for (const char a : components) {
            for (const char b : components) {
                if (a >= b || (a == 'A' && b == 'Y')) continue;
                const fs::path path = folder / (std::string{a, b} + ".exr");
                write_exr(path, std::vector<ChannelView>{{layer + a, &image}, {layer + b, &image}}, {});
                const std::optional<ImageFile> plain = read_plain_exr(path);
                ASSERT_TRUE(plain) << path;
                EXPECT_EQ(plain->channel_names, image_formats().read(path).channel_names) << path;
            }
        }
    }
}

TEST(PlainExr, OfHalfFloatsIsReadAsOpenImageIOReadsIt) {
    const fs::path path = output_dir() / "half.exr";
    const ImageF image = random_visibility(33, 21, 4);
    std::vector<Imath::half> halves(image.pixels.begin(), image.pixels.end());
    Imf::Header header(image.width, image.height);
    header.channels().insert("AO.R", Imf::Channel(Imf::HALF));
    Imf::FrameBuffer frame;
    frame.insert("AO.R", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data()), sizeof(Imath::half),
                                    sizeof(Imath::half) * static_cast<std::size_t>(image.width)));
    {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }
    const std::optional<ImageFile> plain = read_plain_exr(path);
    ASSERT_TRUE(plain);
    expect_same(*plain, image_formats().read(path), path);
}

TEST(PlainExr, IsNoFileOfAnotherKind) {
    const fs::path path = output_dir() / "other.exr";
    const ImageF image = random_visibility(20, 10, 1);
    const auto is_plain = [&](const std::vector<testing::ExrPart>& parts, int width, int height) {
        testing::write_parts(path, parts, width, height);
        return read_plain_exr(path).has_value();
    };
    EXPECT_TRUE(is_plain({{"", {{"Y", &image}}}}, 20, 10));
    EXPECT_FALSE(is_plain({{"", {{"Y", &image}}, 3, 2}}, 30, 20)) << "a part of its frame";
    EXPECT_FALSE(is_plain({{"a", {{"Y", &image}}}, {"b", {{"Y", &image}}}}, 20, 10)) << "two parts";
    EXPECT_FALSE(is_plain({{"", {{"AO.A", &image}, {"AO.Y", &image}}}}, 20, 10)) << "another order";
    for (const char* name : {"Red", "AO.red", "AO", ".Y", "AO.U"})
        EXPECT_FALSE(is_plain({{"", {{name, &image}}}}, 20, 10)) << name;
}

TEST(PlainExr, IsNoBrokenFile) {
    const fs::path folder = output_dir(), path = folder / "whole.exr", broken = folder / "broken.exr";
    const ImageF image = random_visibility(200, 100, 1);
    const std::vector<ChannelView> channels{{"Y", &image}};
    write_exr(path, channels, {});
    const std::string bytes = read_file(path);
    for (const double share : {0.01, 0.1, 0.5, 0.99}) {
        testing::write_bytes(
            broken, bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
        EXPECT_FALSE(read_plain_exr(broken)) << share;
        EXPECT_THAT(testing::file_error_of([&] { read_image(broken); }), ::testing::HasSubstr("broken.exr"))
            << share;
    }
}

TEST(PlainExr, OfAnotherProgramIsReadAsOpenImageIOReadsIt) {
    REQUIRE_SHARED_INPUTS();
    std::size_t plain_files = 0;
    for (const auto& entry : fs::directory_iterator(testing::shared_dir() / "abroad")) {
        if (entry.path().extension() != ".exr") continue;
        const std::optional<ImageFile> plain = read_plain_exr(entry.path());
        if (!plain) continue;
        ++plain_files;
        expect_same(*plain, image_formats().read(entry.path()), entry.path());
    }
    EXPECT_GT(plain_files, 0U);
}

}  // namespace
}  // namespace aoscore
