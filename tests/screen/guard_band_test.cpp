// Compares pictures inside of a guard band with those of a wider camera, and with a whole scene's.
#include "core/error.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr GuardBand kBand{32, false};

/// A room of three walls that goes on to all sides of the picture.
Scene open_corner() {
    Scene scene = empty_scene();
    add_quad(scene, {-30, -1, 0}, {60, 0, 0}, {0, 0, -30});
    add_quad(scene, {-30, -10, -6}, {60, 0, 0}, {0, 30, 0});
    for (int i = -12; i < 12; ++i) add_quad(scene, {0.7 * i, -1, -5.5}, {0.3, 0, 0.1}, {0, 6, 0});
    return scene;
}

Camera looking_ahead() {
    Camera camera = front_camera();
    camera.fovy_rad = std::numbers::pi / 3;
    return camera;
}

/// The camera whose picture has so many pixels more on every side, made without the code under test.
CameraFrame wider(int band_px) {
    Camera camera = looking_ahead();
    camera.fovy_rad = 2 * std::atan(std::tan(camera.fovy_rad / 2) * (kHeight + 2.0 * band_px) / kHeight);
    return {camera, kWidth + 2 * band_px, kHeight + 2 * band_px};
}

ImageF cut(const ImageF& wide, int band_px) {
    ImageF inner(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) inner.at(x, y) = wide.at(x + band_px, y + band_px);
    }
    return inner;
}

/// The mean difference of two pictures, and its part in the outermost eight pixels.
struct Difference {
    double all = 0, at_the_edge = 0;
};
Difference difference(const ImageF& a, const ImageF& b) {
    Difference result;
    int edge = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double d = std::abs(static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y)));
            result.all += d / static_cast<double>(a.size());
            if (std::min({x, y, a.width - 1 - x, a.height - 1 - y}) >= 8) continue;
            result.at_the_edge += d;
            ++edge;
        }
    }
    result.at_the_edge /= edge;
    return result;
}

class GuardBands : public ::testing::TestWithParam<std::string> {
  protected:
    GuardBands() { renderer_.set_scene(open_corner()); }

    MethodOutput drawn(const CameraFrame& frame, const GuardBand& band) {
        renderer_.draw_gbuffer(frame, gbuffer_inputs());
        MethodRequest request = request_for(find_method(methods_, GetParam()), filters_, "default");
        request.guard_band = band;
        return renderer_.run(request);
    }

  private:
    std::vector<MethodDescriptor> methods_ = load_methods(), filters_ = load_filters();
    ScreenRenderer renderer_;
};

// The wider camera's matrices differ in the last bit, which can move a tap to the next texel.
TEST_P(GuardBands, ShowTheInnerPixelsOfAWiderCamera) {
    const MethodOutput inside = drawn({looking_ahead(), kWidth, kHeight}, kBand);
    const MethodOutput wide = drawn(wider(32), {});
    ASSERT_EQ(inside.raw.width, kWidth);
    ASSERT_EQ(inside.visibility.height, kHeight);
    EXPECT_LT(difference(inside.raw, cut(wide.raw, 32)).all, 1e-4);
    EXPECT_LT(difference(inside.visibility, cut(wide.visibility, 32)).all, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Methods, GuardBands, ::testing::ValuesIn(method_ids()),
                         [](const auto& test) { return test_name(test.param); });

/// Methods that look no farther than a radius in metres, over one depth a texel of one camera, with noise
/// that repeats every four pixels: the same in any band of a multiple of four.
std::vector<MethodDescriptor> repeating_methods() {
    std::vector<MethodDescriptor> methods;
    for (MethodDescriptor& method : load_methods()) {
        const Parameter* radius = method.find_parameter("radius");
        const Parameter* noise = method.find_parameter("noise");
        if (radius == nullptr || noise == nullptr || radius->unit != "m") continue;
        if (method.depth_layers || method.side_layers) continue;
        const bool by_picture =
            std::ranges::any_of(method.parameters, [](const Parameter& p) { return p.unit == "uv"; });
        if (!by_picture && method.passes.size() == 1 && noise->accepts(ParameterValue("tiled_4x4")))
            methods.push_back(std::move(method));
    }
    return methods;
}

// A band wider than the projected radius shows all that a method can reach: the nearest surface in the
// picture lies at a depth of 1.7 m, where .8 m are 26 pixels.
TEST(GuardBand, ChangesNothingWhenItIsWidenedBeyondTheRadius) {
    ScreenRenderer renderer;
    renderer.set_scene(open_corner());
    const std::vector<MethodDescriptor> methods = repeating_methods();
    ASSERT_GE(methods.size(), 6U);
    for (const MethodDescriptor& method : methods) {
        MethodRequest request;
        request.method = &method;
        request.parameters = method.values("default", {{"radius", 0.8}, {"noise", "tiled_4x4"}});
        const auto drawn = [&](const CameraFrame& frame, double band_px) {
            renderer.draw_gbuffer(frame, gbuffer_inputs());
            request.guard_band = {band_px, false};
            return renderer.run(request).raw;
        };
        const CameraFrame frame(looking_ahead(), kWidth, kHeight);
        const ImageF none = drawn(frame, 0), enough = drawn(frame, 32), more = cut(drawn(wider(64), 0), 64);
        const Difference left = difference(enough, more), mended = difference(none, more);
        EXPECT_LT(left.all, 1e-4) << method.id;
        EXPECT_GT(mended.at_the_edge, 20 * left.at_the_edge) << method.id;
        EXPECT_GT(mended.at_the_edge, 2 * mended.all) << method.id;
        RecordProperty(method.id, std::to_string(mended.at_the_edge));
    }
}

TEST(GuardBand, IsReadInPixelsAndPerCent) {
    EXPECT_EQ(parse_guard_band("64").pixels(640, 360), glm::ivec2(64));
    EXPECT_EQ(parse_guard_band("10%").pixels(640, 360), glm::ivec2(64, 36));
    EXPECT_EQ(parse_guard_band("2.5%").pixels(641, 360), glm::ivec2(17, 9)) << "rounded up";
    EXPECT_EQ(parse_guard_band("0%"), GuardBand{});
    for (const char* text : {"64", "10%", "2.5%", "0"}) EXPECT_EQ(text_of(parse_guard_band(text)), text);
    for (const char* text : {"", "%", "-1", "1.5", "64px", "101%", "4097", "nan", "inf", "1e3%"})
        EXPECT_THROW(parse_guard_band(text), Error) << text;
}

TEST(GuardBand, CostsTheBytesAndFetchesOfItsPixelsAndLeavesTheGBufferAlone) {
    ScreenRenderer renderer;
    renderer.set_scene(open_corner());
    renderer.draw_gbuffer(CameraFrame(looking_ahead(), kWidth, kHeight), gbuffer_inputs());
    const std::string before = renderer.gbuffer_digest();
    const std::vector<MethodDescriptor> methods = load_methods();
    MethodRequest plain;
    plain.method = &find_method(methods, "alchemy");
    plain.parameters = plain.method->values("default");
    MethodRequest banded = plain;
    banded.guard_band = {25, true};
    const double pixels = 1.5 * 1.5;
    EXPECT_EQ(static_cast<double>(renderer.gbuffer_bytes(banded)),
              pixels * static_cast<double>(renderer.gbuffer_bytes(plain)));
    EXPECT_TRUE(renderer.time(banded).gbuffer.has_value());
    EXPECT_FALSE(renderer.time(plain).gbuffer.has_value());
    EXPECT_EQ(renderer.count_fetches(banded).width, kWidth);
    renderer.run(banded);
    EXPECT_EQ(renderer.gbuffer_digest(), before);
}

}  // namespace
}  // namespace aoscore::testing
