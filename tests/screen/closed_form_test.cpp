#include "hand_made.h"
#include "scene/builtin/closed_forms.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;

// Looking straight down on a floor. The picture's border is clamped: in an orthographic view, what is there
// goes on for ever.
class SeenAlongTheNormal : public ::testing::Test {
  protected:
    static constexpr double kPixel_m = 0.01;

    static CameraFrame frame(int width, int height) {
        Camera camera = front_camera();
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = height * kPixel_m / 2;
        return CameraFrame(camera, width, height);
    }

    ImageF run(const Scene& scene, int width, int height, const std::string& method,
               ParameterValues settings) {
        static const auto methods = load_methods();
        renderer_.set_scene(scene);
        renderer_.draw_gbuffer(frame(width, height), {"normal_geometric"});
        MethodRequest request;
        request.method = &find_method(methods, method);
        request.parameters = request.method->values("default", settings);
        request.border = Border::clamp;
        return renderer_.run(request).raw;
    }

    // A floor before a wall `ratio` times as high as it is away.
    double beside_wall(double ratio, const std::string& method, const ParameterValues& settings) {
        constexpr int kWallPx = 40, kWidth = 128, kHeight = 8;
        constexpr double kDistance = kWallPx * kPixel_m, kFloor = -20;
        const double edge = kWidth / 2 * kPixel_m, top = kFloor + ratio * kDistance;
        Scene scene = plane_scene({0, 0, kFloor}, {0, 0, 1}, 50);
        add_quad(scene, {-50, -50, top}, {50 - edge + kWallPx * kPixel_m, 0, 0}, {0, 100, 0});
        // Texel 40 is the first of the floor; 79 lies half a pixel short of the wall's distance, as the taps
        // on the wall lie half a pixel behind its edge.
        const ImageF image = run(scene, kWidth, kHeight, method, settings);
        double sum = 0;
        for (int y = 0; y < kHeight; ++y) sum += static_cast<double>(image.at(2 * kWallPx - 1, y));
        return sum / kHeight;
    }

    // The middle of a round pit whose rim is seen at this zenith angle.
    double in_pit(double rim_zenith, const std::string& method, const ParameterValues& settings) {
        constexpr int kSize = 121, kRadiusPx = 40;
        constexpr double kRadius = kRadiusPx * kPixel_m, kFloor = -20;
        const double top = kFloor + kRadius / std::tan(rim_zenith);
        Scene scene = plane_scene({0, 0, kFloor}, {0, 0, 1}, 50);
        constexpr int kSegments = 256;
        for (int i = 0; i < kSegments; ++i) {
            const double a = 2 * kPi * i / kSegments, b = 2 * kPi * (i + 1) / kSegments;
            Mesh mesh;
            for (const auto& [angle, r] :
                 {std::pair(a, kRadius), std::pair(b, kRadius), std::pair(b, 50.0), std::pair(a, 50.0)}) {
                mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), top);
            }
            mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
            scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
            scene.meshes.push_back(std::move(mesh));
        }
        const ImageF image = run(scene, kSize, kSize, method, settings);
        double sum = 0;
        for (int y = -2; y < 2; ++y) {
            for (int x = -2; x < 2; ++x) sum += static_cast<double>(image.at(kSize / 2 + x, kSize / 2 + y));
        }
        return sum / 16;
    }

    ScreenRenderer renderer_;
};

// So far that what lies beyond counts for less than the tolerance; a step a pixel.
const ParameterValues kFineGtao = {{"slices", 32}, {"steps", 400}, {"step_power", 1.0}, {"radius", 4.0}};
const ParameterValues kFineHbao = {{"directions", 64}, {"steps", 400},        {"radius", 4.0},
                                   {"bias", 0.0},      {"threshold", 3.1416}, {"falloff", "none"}};
ParameterValues fine_bitmask(const char* weights) {
    ParameterValues settings = kFineGtao;
    settings["thickness"] = 1000.0;
    settings["weights"] = weights;
    return settings;
}
const ParameterValues kFineRays = {{"directions", 256}, {"steps", 250}, {"radius", 2.5}};
// For the pit, whose rim is nearer.
ParameterValues short_range(ParameterValues settings) {
    settings["radius"] = 1.0;
    settings["steps"] = 100;
    return settings;
}

constexpr double kTolerance = 0.008;

TEST_F(SeenAlongTheNormal, WallIsExactToGtaoAndToTheUnbiasedBitmask) {
    for (const double k : {0.5, 1.0, 2.0}) {
        const double exact = closed_form::wall_visibility(1, k);
        const double gtao = beside_wall(k, "gtao", kFineGtao);
        const double bitmask = beside_wall(k, "visibility-bitmask", fine_bitmask("cosine"));
        std::printf("wall k %.1f: exact %.4f gtao %.4f bitmask unbiased %.4f\n", k, exact, gtao, bitmask);
        EXPECT_NEAR(gtao, exact, kTolerance);
        EXPECT_NEAR(bitmask, exact, kTolerance);
    }
}

// A ray as long as 4 m leaves over the wall what a longer one would hit: none here, the wall is lower than
// that.
TEST_F(SeenAlongTheNormal, WallIsExactToTheRayMarch) {
    for (const double k : {0.5, 1.0, 2.0}) {
        const double got = beside_wall(k, "ray-march", kFineRays);
        std::printf("wall k %.1f: ray-march %.4f\n", k, got);
        EXPECT_NEAR(got, closed_form::wall_visibility(1, k), 0.015);
    }
}

TEST_F(SeenAlongTheNormal, PitIsExactToTheLineSweep) {
    for (const double h : {30.0, 60.0}) {
        const double rim = h * kPi / 180;
        const double got = in_pit(rim, "line-sweep", {{"directions", 64}});
        std::printf("pit %.0f: line-sweep %.4f, expected %.4f\n", h, got, closed_form::pit_visibility(rim));
        EXPECT_NEAR(got, closed_form::pit_visibility(rim), 0.015);
    }
}

// HBAO weights the hemisphere uniformly: 1 - atan(k)/π.
TEST_F(SeenAlongTheNormal, WallReadsTheUniformHemisphereToHbao) {
    for (const double k : {0.5, 1.0, 2.0}) {
        const double got = beside_wall(k, "hbao", kFineHbao);
        std::printf("wall k %.1f: hbao %.4f expected %.4f\n", k, got, 1 - std::atan(k) / kPi);
        EXPECT_NEAR(got, 1 - std::atan(k) / kPi, kTolerance);
    }
}

// Uniform sectors: the mean over azimuths of the open angle over π.
TEST_F(SeenAlongTheNormal, WallReadsTheMeanAngleToTheUniformBitmask) {
    for (const auto& [k, expected] :
         {std::pair(0.5, 0.9037), std::pair(1.0, 0.8287), std::pair(2.0, 0.7371)}) {
        const double got = beside_wall(k, "visibility-bitmask", fine_bitmask("uniform"));
        std::printf("wall k %.1f: bitmask %.4f expected %.4f\n", k, got, expected);
        EXPECT_NEAR(got, expected, kTolerance);
    }
}

TEST_F(SeenAlongTheNormal, PitReadsEachMethodsOwnMeasure) {
    for (const double h : {30.0, 60.0}) {
        const double rim = h * kPi / 180;
        const double gtao = in_pit(rim, "gtao", short_range(kFineGtao));
        const double unbiased = in_pit(rim, "visibility-bitmask", short_range(fine_bitmask("cosine")));
        const double uniform = in_pit(rim, "visibility-bitmask", short_range(fine_bitmask("uniform")));
        const double hbao = in_pit(rim, "hbao", short_range(kFineHbao));
        const double rays = in_pit(rim, "ray-march", short_range(kFineRays));
        std::printf(
            "pit %.0f: sin2 %.4f gtao %.4f unbiased %.4f rays %.4f | 2h/pi %.4f uniform %.4f | 1-cos %.4f "
            "hbao %.4f\n",
            h, closed_form::pit_visibility(rim), gtao, unbiased, rays, 2 * rim / kPi, uniform,
            1 - std::cos(rim), hbao);
        EXPECT_NEAR(gtao, closed_form::pit_visibility(rim), 0.015);
        EXPECT_NEAR(rays, closed_form::pit_visibility(rim), 0.015);
        // 32 sectors round the rim to 5.6 degrees.
        EXPECT_NEAR(unbiased, closed_form::pit_visibility(rim), 0.05);
        EXPECT_NEAR(uniform, 2 * rim / kPi, 1.0 / 32 + 0.01);
        EXPECT_NEAR(hbao, 1 - std::cos(rim), 0.015);
    }
}

}  // namespace
}  // namespace aoscore::testing
