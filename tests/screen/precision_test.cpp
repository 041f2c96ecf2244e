#include "screen/gbuffer/precision.h"

#include "core/files.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore::testing {
namespace {

class EveryPrecision : public ::testing::TestWithParam<PrecisionFormat> {};

// The largest error of depth by a format: half a step of its integers, or some rounding of floats.
double allowed_error(Precision precision, const Camera& camera, double depth) {
    const bool orthographic = camera.projection == Camera::Projection::orthographic;
    const double span = camera.far - camera.near;
    constexpr double kUlp = 0x1p-23;
    const double rounding = 8 * kUlp * (orthographic ? camera.far : depth);
    // The derivative of depth by window depth, which is itself computed in floats.
    const double window = orthographic ? span : depth * depth * span / (camera.near * camera.far);
    switch (precision) {
        case Precision::full:
        case Precision::normal_xy:
        case Precision::positions:
        case Precision::depth_32f_reversed:
            return rounding;
        case Precision::depth_32f:
            return rounding + 4 * kUlp * window;
        case Precision::depth_24:
            return rounding + (0.5 / 16777215 + 4 * kUlp) * window;
        case Precision::depth_16:
            return rounding + (0.5 / 65535 + 4 * kUlp) * window;
        case Precision::linear_16:
            return rounding + (0.5 / 65535 + 2 * kUlp) * span;
        case Precision::linear_16_300m:
            return rounding + (0.5 / 65535 + 2 * kUlp) * 300;
        case Precision::packed_rgba8:
            return rounding + 1.0 / 65025 * span;
    }
    return 0;
}

// A method's picture clips at 1; a power of two keeps depth exact.
constexpr double kShownPerMetre = 1.0 / 1024;

// A method that shows its depth input.
const MethodDescriptor& depth_viewer(std::vector<MethodDescriptor>& methods) {
    const auto folder = output_dir();
    write_atomically(folder / "viewer" / "method.json", R"({"label": "v", "paper": "none", "summary": "v",
        "passes": [{"fragment": "v.frag", "inputs": ["linear_depth"]}]})");
    write_atomically(folder / "viewer" / "v.frag", R"(#include "contract/ao_pass.glsl"
        float visibility(vec2 image_px, vec3 position) { return -position.z / 1024.0; })");
    methods = load_methods(folder);
    return find_method(methods, "viewer");
}

TEST_P(EveryPrecision, RoundsDepthNoFurtherThanItsFormatSays) {
    const PrecisionFormat& format = GetParam();
    std::vector<MethodDescriptor> methods;
    MethodRequest request;
    request.method = &depth_viewer(methods);
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
        Camera camera = corner_camera();
        camera.projection = projection;
        camera.half_height = 2;
        const CameraFrame frame(camera, 240, 135);
        renderer.draw_gbuffer(frame, {});
        const GBufferImages exact = renderer.read_gbuffer();
        request.precision = format.precision;
        const ImageF shown = renderer.run(request).raw;
        std::size_t surface = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (exact.surface.pixels[i] == 0) continue;
            ++surface;
            const double depth = static_cast<double>(exact.linear_depth().pixels[i]);
            ASSERT_NEAR(static_cast<double>(shown.pixels[i]) / kShownPerMetre, depth,
                        allowed_error(format.precision, camera, depth))
                << format.id << ", pixel " << i;
        }
        EXPECT_GT(surface, 1000U);
    }
}

TEST_P(EveryPrecision, ReachesNormalsFromDepthAndLeavesBackgroundAlone) {
    const auto methods = load_methods();
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 120, 67), gbuffer_inputs());
    const Mask surface = renderer.read_gbuffer().surface;
    MethodRequest request;
    request.method = &find_method(methods, "alchemy");
    request.parameters = request.method->values("default");
    request.normals = Normals::from_depth;
    const ImageF exact = renderer.run(request).raw;
    request.precision = GetParam().precision;
    const ImageF stored = renderer.run(request).raw;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        ASSERT_TRUE(stored.pixels[i] >= 0 && stored.pixels[i] <= 1);
        if (surface.pixels[i] == 0) {
            ASSERT_EQ(stored.pixels[i], 1.0F);
        }
    }
    const bool keeps_depth = GetParam().stored.empty() || GetParam().positions;
    if (keeps_depth && GetParam().normals.empty()) {
        EXPECT_EQ(exact.pixels, stored.pixels);
    } else if (!keeps_depth) {
        EXPECT_NE(exact.pixels, stored.pixels);
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryPrecision, ::testing::ValuesIn(precision_formats()),
                         [](const auto& tested) {
                             std::string name(tested.param.id);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace aoscore::testing
