// A channel needs only its row in image/channels.h to be drawn, read by shaders and read back.
#include "image/channels.h"

#include "core/files.h"
#include "core/known_names.h"
#include "hand_made.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <set>

namespace aoscore::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kWidth = 96, kHeight = 54;

/// A method whose only pass lists this input and returns that expression.
MethodDescriptor method_of(std::string_view input, const std::string& expression) {
    const fs::path folder = output_dir() / "probe";
    fs::create_directories(folder);
    const std::string besides =
        input == "linear_depth" ? std::string() : fmt::format(", \"{}\"", input);  // ao_pass.glsl reads depth
    std::ofstream(folder / "method.json") << fmt::format(
        R"({{"label": "Probe", "paper": "none", "summary": "Returns an input", "parameters": {{}},
             "presets": {{}}, "passes": [{{"fragment": "probe.frag", "inputs": ["linear_depth"{}]}}]}})",
        besides);
    std::ofstream(folder / "probe.frag") << fmt::format(
        "#include \"contract/ao_pass.glsl\"\nfloat visibility(vec2 image_px, vec3 position) {{ return {}; "
        "}}\n",
        expression);
    return find_method(load_methods(folder.parent_path()), "probe");
}

class EveryChannel : public ::testing::TestWithParam<std::string> {
  protected:
    EveryChannel() { renderer_.set_scene(corner_scene()); }

    GBufferImages drawn() {
        renderer_.draw_gbuffer(CameraFrame(corner_camera(), kWidth, kHeight), {std::string(channel_.id)});
        return renderer_.read_gbuffer();
    }
    /// One component as the probe reads it, moved into [0,1].
    ImageF read_by_a_pass(const char* component) {
        const MethodDescriptor method =
            method_of(channel_.id, fmt::format("0.5 + centre_{}(){} / 256.0", channel_.id, component));
        return renderer_.run(request_for(method, {}, "default")).raw;
    }

    const Channel& channel_ = *find_row(gbuffer_channels(), GetParam());
    ScreenRenderer renderer_;
};

TEST_P(EveryChannel, IsDrawnWhenItIsAskedForAndOnlyThen) {
    const GBufferImages images = drawn();
    for (const Channel& other : gbuffer_channels()) {
        const bool there = other.always_drawn || other.id == channel_.id;
        const bool is_number = other.form == ChannelForm::number;
        EXPECT_EQ(images.number(other.id).size(), there && is_number ? kWidth * kHeight : 0) << other.id;
        EXPECT_EQ(images.vector(other.id).size(), there && !is_number ? kWidth * kHeight : 0) << other.id;
    }
}

TEST_P(EveryChannel, HoldsTheTablesBackgroundWhereNothingIsDrawn) {
    const GBufferImages images = drawn();
    const auto far = static_cast<float>(corner_camera().far);
    const auto& expected = channel_.background;
    std::size_t background = 0;
    for (std::size_t i = 0; i < images.surface.size(); ++i) {
        if (images.surface.pixels[i] != 0) continue;
        ++background;
        if (channel_.form == ChannelForm::number)
            EXPECT_EQ(images.number(channel_.id).pixels[i], channel_.background_is_far ? far : expected[0]);
        else
            EXPECT_EQ(images.vector(channel_.id).pixels[i], glm::vec3(expected[0], expected[1], expected[2]));
    }
    EXPECT_GT(background, 100U);
}

TEST_P(EveryChannel, IsReadByAPassAsItIsReadBack) {
    const GBufferImages images = drawn();
    constexpr std::array<const char*, 3> kComponents = {".x", ".y", ".z"};
    for (std::size_t c = 0; c < channel_.values(); ++c) {
        const bool is_number = channel_.form == ChannelForm::number;
        const ImageF read = read_by_a_pass(is_number ? "" : kComponents[c]);
        for (std::size_t i = 0; i < images.surface.size(); ++i) {
            if (images.surface.pixels[i] == 0) continue;
            const float value = is_number
                                    ? images.number(channel_.id).pixels[i]
                                    : images.vector(channel_.id).pixels[i][static_cast<glm::length_t>(c)];
            ASSERT_FLOAT_EQ(read.pixels[i], 0.5F + value / 256) << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Channels, EveryChannel, ::testing::ValuesIn(ids_of(gbuffer_channels())),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(Channels, HaveANameInFilesForEachValueAndNoTwoShareOne) {
    std::set<std::string_view> names = {"Y", "mask.Y", "P.X", "P.Y",
                                        "P.Z"};  // further channels of a G-buffer's file
    std::set<std::string_view> ids;
    for (const Channel& channel : gbuffer_channels()) {
        EXPECT_TRUE(ids.insert(channel.id).second) << channel.id;
        EXPECT_EQ(channel.exr_names.size(), channel.values()) << channel.id;
        for (const std::string_view name : channel.exr_names) EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_FALSE(channel.on_page && channel.form == ChannelForm::colour) << channel.id;
    }
    for (const MadeInput& input : made_inputs()) EXPECT_TRUE(ids.insert(input.id).second) << input.id;
}

TEST(Channels, AreDescribedWhereAnAuthorOfAMethodReads) {
    const std::string text = read_file(source_dir() / "shaders" / "README.md");
    for (const Channel& channel : gbuffer_channels())
        EXPECT_THAT(text, HasSubstr(fmt::format("`{}`", channel.id)));
    for (const MadeInput& input : made_inputs()) EXPECT_THAT(text, HasSubstr(fmt::format("`{}`", input.id)));
}

}  // namespace
}  // namespace aoscore::testing
