#include "core/error.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace aoscore::testing {
namespace {

// Rules that every method must keep. A new folder in shaders/methods/ is tested without an entry here.
class EveryMethod : public ::testing::TestWithParam<std::string> {
  protected:
    static const std::vector<MethodDescriptor>& methods() {
        static const auto all = load_methods();
        return all;
    }
    static const std::vector<MethodDescriptor>& filters() {
        static const auto all = load_filters();
        return all;
    }
    const MethodDescriptor& method() const { return find_method(methods(), GetParam()); }

    static void look_at_corner(ScreenRenderer& renderer, int width = 240, int height = 135) {
        renderer.set_scene(corner_scene());
        renderer.draw_gbuffer(CameraFrame(corner_camera(), width, height), gbuffer_inputs());
    }
};

bool in_unit_range(const ImageF& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v >= 0 && v <= 1; });
}

TEST_P(EveryMethod, IsFiniteAndInRangeInEveryPreset) {
    ScreenRenderer renderer;
    look_at_corner(renderer);
    const Mask surface = renderer.read_gbuffer().surface;
    for (const std::string& preset : drawn_presets(method())) {
        const MethodOutput output = renderer.run(request_for(method(), filters(), preset));
        write_png((output_dir() / (preset + ".png")).string(), output.visibility);
        EXPECT_TRUE(in_unit_range(output.raw)) << preset;
        EXPECT_TRUE(in_unit_range(output.visibility)) << preset;
        EXPECT_LT(mean_over(output.raw, surface), 0.9999) << preset << " sees no occlusion in a corner";
        for (std::size_t i = 0; i < surface.size(); ++i) {
            if (surface.pixels[i] == 0) {
                ASSERT_EQ(output.raw.pixels[i], 1.0F);
                ASSERT_EQ(output.visibility.pixels[i], 1.0F);
            }
        }
    }
}

TEST_P(EveryMethod, GivesTheSameImageAgainInTheSameAndInAnotherContext) {
    const MethodRequest request = request_for(method(), filters(), "default");
    const auto render = [&] {
        ScreenRenderer renderer;
        look_at_corner(renderer);
        const ImageF once = renderer.run(request).visibility;
        EXPECT_EQ(once.pixels, renderer.run(request).visibility.pixels);
        return once;
    };
    EXPECT_EQ(render().pixels, render().pixels);
}

TEST_P(EveryMethod, LeavesTheGBufferAsItWas) {
    ScreenRenderer renderer;
    look_at_corner(renderer);
    const std::string before = renderer.gbuffer_digest();
    const MethodRequest request = request_for(method(), filters(), "default");
    renderer.run(request);
    renderer.count_fetches(request);
    renderer.time(request);
    EXPECT_EQ(renderer.gbuffer_digest(), before);
}

TEST_P(EveryMethod, GivesTheSameImageWithUniformParameters) {
    ScreenRenderer renderer;
    look_at_corner(renderer);
    for (const std::string& preset : drawn_presets(method())) {
        MethodRequest request = request_for(method(), filters(), preset);
        const ImageF specialised = renderer.run(request).raw;
        request.uniform_form = true;
        const ImageF open = renderer.run(request).raw;
        std::size_t different = 0;
        for (std::size_t i = 0; i < open.size(); ++i)
            different += std::abs(open.pixels[i] - specialised.pixels[i]) > 1e-3F ? 1 : 0;
        // Another order of rounding may push a few taps over a texel's edge.
        EXPECT_LE(different, open.size() / 1000) << preset;
    }
}

TEST_P(EveryMethod, CountsTapsOnSurfacesAlone) {
    ScreenRenderer renderer;
    look_at_corner(renderer);
    const GBufferImages images = renderer.read_gbuffer();
    const ImageF fetches = renderer.count_fetches(request_for(method(), filters(), "default"));
    EXPECT_GE(mean_over(fetches, images.surface), 1);
    for (std::size_t i = 0; i < fetches.size(); ++i) {
        if (images.surface.pixels[i] == 0) {
            ASSERT_EQ(fetches.pixels[i], 0);
        }
    }
}

TEST_P(EveryMethod, RejectsUnknownPresetsAndParametersWithTheKnownOnes) {
    const auto message = [](const std::function<void()>& action) {
        try {
            action();
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_NE(message([&] { method().values("no-such-preset"); }).find("default"), std::string::npos);
    EXPECT_NE(message([&] {
                  method().values("default", {{"no_such_parameter", 1}});
              }).find("no_such_parameter"),
              std::string::npos);
    for (const Parameter& p : method().parameters) {
        EXPECT_NE(message([&] { method().values("default", {{p.id, "no such value"}}); }), "") << p.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethod, ::testing::ValuesIn(method_ids()),
                         [](const auto& tested) { return test_name(tested.param); });

// Hussain 2022 implies these counts for its tables: one depth fetch a sample.
TEST(Fetches, AreThoseOfThePublishedTables) {
    const auto methods = load_methods();
    const auto filters = load_filters();
    ScreenRenderer renderer;
    renderer.set_scene(plane_scene({0, 0, -5}, {0, 0, 1}, 50));
    const CameraFrame frame(front_camera(), 64, 64);
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const Mask surface = renderer.read_gbuffer().surface;
    const auto count = [&](const char* method, const char* preset) {
        return mean_over(renderer.count_fetches(request_for(find_method(methods, method), filters, preset)),
                         surface);
    };
    EXPECT_EQ(count("crytek-ssao", "performance-wide"), 16);
    EXPECT_EQ(count("crytek-ssao", "quality"), 64);
    EXPECT_EQ(count("hbao-hussain", "performance-wide"), 36);
    EXPECT_EQ(count("hbao-hussain", "quality"), 320);
    EXPECT_EQ(count("hbao", "performance-wide"), 36);
    EXPECT_EQ(count("hbao", "quality"), 320);
    EXPECT_EQ(count("alchemy", "performance-wide"), 12);
    EXPECT_EQ(count("alchemy", "quality"), 64);
}

}  // namespace
}  // namespace aoscore::testing
