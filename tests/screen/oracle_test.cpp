#include "oracle.h"

#include "hand_made.h"
#include "oracle_cases.h"
#include "oracle_formulas.h"
#include "oracle_pictures.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace aoscore::testing {
namespace {

using glm::dvec3;
using namespace formula;

// A slope, a bump, a hollow and a steep step, 6 m away. At none of its texels a formula changes abruptly.
double terrain(double x, double y) {
    const double bump = 0.18 * std::exp(-((x + 0.2) * (x + 0.2) + (y - 0.15) * (y - 0.15)) / 0.02);
    const double hollow = -0.15 * std::exp(-((x - 0.15) * (x - 0.15) + (y + 0.2) * (y + 0.2)) / 0.015);
    return -6 + 0.25 * x + bump + hollow + 0.2 * smooth_step(0.2, 0.26, y + 0.3 * x);
}

// The compared pixels, which are far enough from the border for every radius.
const std::vector<glm::ivec2> kPixels = {{60, 60}, {46, 52}, {70, 76}, {72, 45}, {52, 66}, {64, 48}};

class Estimator : public ::testing::TestWithParam<Case> {};

TEST_P(Estimator, AgreesWithItsPapersFormulaInDoublePrecision) {
    const Case& c = GetParam();
    const auto methods = load_methods();
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = kSize * kPixel / 2;
    const CameraFrame frame(camera, kSize, kSize);
    ScreenRenderer renderer;
    renderer.set_scene(height_field_scene(terrain, kPixel));
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const GBufferImages images = renderer.read_gbuffer();
    MethodRequest request;
    request.method = &find_method(methods, c.method);
    request.parameters = request.method->values("default", c.settings);
    request.uniform_form = c.seeds > 1;
    ImageF mean(kSize, kSize, 0);
    for (request.seed = 1; request.seed <= static_cast<std::uint64_t>(c.seeds); ++request.seed) {
        const ImageF once = renderer.run(request).raw;
        for (std::size_t i = 0; i < once.size(); ++i)
            mean.pixels[i] += once.pixels[i] / static_cast<float>(c.seeds);
    }
    write_png((output_dir() / "mean.png").string(), mean);

    const Field field{terrain, kPixel};
    for (const glm::ivec2& pixel : kPixels) {
        Point point;
        point.p = frame.view_position(pixel.x + 0.5, pixel.y + 0.5,
                                      static_cast<double>(images.linear_depth().at(pixel.x, pixel.y)));
        point.n = glm::normalize(dvec3(images.vector("normal_geometric").at(pixel.x, pixel.y)));
        const double expected = c.expected(field, point),
                     got = static_cast<double>(mean.at(pixel.x, pixel.y));
        std::printf("%-22s (%d, %d): read %.4f, expected %.4f\n", c.name, pixel.x, pixel.y, got, expected);
        EXPECT_NEAR(got, expected, c.tolerance) << "pixel " << pixel.x << ", " << pixel.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Estimator, ::testing::ValuesIn(cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// In a bowl each level is alike from pixel to pixel, so that upsampling changes nothing: the picture is the
// darkest level, or the product of all. A level is the mean over a checkerboard of its own pixels.
TEST(MultiResolution, ReadsItsLevelsFormulasAtTheBottomOfABowl) {
    constexpr double kCurvature = 1.5, kBottom = -6, kStrength = 2;
    const auto bowl = [](double x, double y) { return kBottom + kCurvature / 2 * (x * x + y * y); };
    const auto methods = load_methods();
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = kSize * kPixel / 2;
    ScreenRenderer renderer;
    renderer.set_scene(height_field_scene(bowl, kPixel));
    renderer.draw_gbuffer(CameraFrame(camera, kSize, kSize), gbuffer_inputs());
    double darkest = 1, product = 1;
    for (const int scale : {1, 2, 4, 8}) {
        double sum = 0, taps = 0;
        for (int y = -2; y <= 2; ++y) {
            for (int x = -2; x <= 2; ++x) {
                if (((x + y) & 1) != 0 || (x == 0 && y == 0)) continue;
                const double dx = x * scale * kPixel, dy = y * scale * kPixel;
                const dvec3 v(dx, dy, bowl(dx, dy) - kBottom);
                const double d = glm::length(v);
                sum += std::max(1 - d * d / (kRadius * kRadius), 0.0) * v.z / d;
                taps += 1;
            }
        }
        const double open = 1 - kStrength * sum / taps;
        darkest = std::min(darkest, open);
        product *= open;
    }
    ASSERT_LT(product, darkest - 0.05);
    MethodRequest request;
    request.method = &find_method(methods, "multi-resolution");
    for (const auto& [join, expected] : {std::pair("max", darkest), std::pair("product", product)}) {
        request.parameters =
            request.method->values("default", {{"radius", kRadius}, {"strength", kStrength}, {"join", join}});
        const double read = static_cast<double>(renderer.run(request).raw.at(kSize / 2, kSize / 2));
        std::printf("multi-resolution, %s: read %.4f, expected %.4f\n", join, read, expected);
        EXPECT_NEAR(read, expected, 0.01) << join;
    }
}

// A new method must be checked like the others, or be named here with the reason.
TEST(Estimators, OfAllMethodsAreChecked) {
    // The line sweep has no radius: closed_form_test.cpp checks it. Multi-resolution is checked above.
    // three.js' pass, Filament's and Unity's follow no paper: published_test.cpp checks them, like all
    // methods drawn as published. side_cameras_test.cpp checks the one that sees from several cameras.
    std::set<std::string> checked = {"multi-resolution", "line-sweep", "three-gtao",
                                     "filament-ssao",    "unity-ssao", "multi-view-hbao"};
    for (const Case& c : cases()) checked.insert(c.method);
    for (const MethodDescriptor& m : load_methods()) EXPECT_TRUE(checked.contains(m.id)) << m.id;
}

}  // namespace
}  // namespace aoscore::testing
