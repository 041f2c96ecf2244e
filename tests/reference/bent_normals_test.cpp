#include "core/sampling.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi, kDegree = 180 / kPi;

std::string degrees(double angle_rad) {
    return fmt::format("{:.2f}°", angle_rad * kDegree);
}

/// The expected signal of a scene's middle pixel, at the origin with its normal upward.
struct Expected {
    glm::dvec3 bent_normal;  ///< in world space
    double cone_rad;
};

Truth bent_truth(const Scene& scene, const Camera& camera, double radius_m, int samples, std::uint64_t seed,
                 int size = 8) {
    TruthSettings settings;
    settings.samples = samples;
    settings.seed = seed;
    settings.extras.bent_normals = true;
    settings.skip_open = false;
    const ReferenceScene reference(scene);
    return reference.trace(CameraFrame(camera, size, size), {{Falloff::binary, radius_m, 0}}, settings,
                           "bent");
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Compares all pixels of a view so narrow that all see the same with the closed form: errors are in units of
/// the stated ones.
void expect_closed_form(const Scene& scene, const Camera& camera, const Expected& expected) {
    const CameraFrame frame(camera, 8, 8);
    const glm::dmat3 world_from_view(frame.world_from_view());
    double angles = 0, cones = 0, count = 0, sureness = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Truth truth = bent_truth(scene, camera, INFINITY, 1024, seed);
        for (std::size_t i = 0; i < truth.bent_normal.size(); ++i) {
            const glm::dvec3 bent = world_from_view * glm::dvec3(truth.bent_normal.pixels[i]);
            const double z = angle_between(bent, expected.bent_normal) /
                             static_cast<double>(truth.bent_error_rad.pixels[i]);
            const double cone_z = (static_cast<double>(truth.cone_angle_rad.pixels[i]) - expected.cone_rad) /
                                  static_cast<double>(truth.cone_error_rad.pixels[i]);
            EXPECT_LT(z, 5);
            EXPECT_LT(std::abs(cone_z), 5);
            EXPECT_NEAR(glm::length(bent), glm::length(expected.bent_normal), 0.03);
            angles += z * z;
            cones += cone_z * cone_z;
            sureness = std::max(sureness, static_cast<double>(truth.bent_error_rad.pixels[i]));
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(angles / count), 1.3) << "angle";
    EXPECT_LT(std::sqrt(cones / count), 1.3) << "cone";
    EXPECT_LT(sureness, 0.05) << "an error of any size would pass, were it stated as large";
}

Scene floor_only() {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(50, 1));
    return scene;
}

/// A scene whose signal is known at the origin, seen by an eye that looks there.
struct ClosedForm {
    std::string name;
    Scene scene;
    glm::dvec3 eye;
    Expected expected;
};

ClosedForm open_plane() {
    return {"open plane", floor_only(), {0.5, 3, 1}, {{0, 0.5, 0}, kPi / 2}};
}

/// The open quarter of the sphere: its mean direction lies at 45 degrees, sqrt(2)/2 long.
ClosedForm endless_wall() {
    Scene walled = floor_only();
    testing::add(walled, testing::quad({-1e-3, 0, -4000}, {-1e-3, 4000, -4000}, {-1e-3, 4000, 4000},
                                       {-1e-3, 0, 4000}));
    return {"endless wall, a quarter of the sphere",
            std::move(walled),
            {0.5, 3, 1},
            {{0.5, 0.5, 0}, kPi / 2 * (2 - std::numbers::sqrt2)}};
}

/// The bottom of a cylinder about the y axis, so tall that its rim lies at this zenith angle.
ClosedForm pit(double rim_rad) {
    Scene scene = floor_only();
    constexpr int kSides = 256;
    const double height = 1 / std::tan(rim_rad);
    for (int i = 0; i < kSides; ++i) {
        const double a = 2 * kPi * i / kSides, b = 2 * kPi * (i + 1) / kSides;
        const glm::dvec3 from(std::cos(a), 0, std::sin(a)), to(std::cos(b), 0, std::sin(b));
        const glm::dvec3 up(0, height, 0);
        testing::add(scene, testing::quad(from, to, to + up, from + up));
    }
    return {"pit, rim at " + degrees(rim_rad),
            std::move(scene),
            {0.3, 3, 0.2},
            {{0, (1 + std::cos(rim_rad)) / 2, 0}, kPi / 2 * (1 - std::cos(rim_rad))}};
}

/// A wall of finite height h at distance d, endless along z, takes the elevations below atan(h / d) in its
/// own plane: its shadow ends at the plane through z and the wall's top. The open part is the lune between
/// that plane and the floor on the other side, of angle t = pi - atan(h / d); its mean direction lies in
/// its middle, sin(t/2)/t * pi/2 long.
ClosedForm wall(double elevation_rad) {
    Scene walled = floor_only();
    const double h = std::tan(elevation_rad);
    testing::add(walled, testing::quad({-1, 0, -4e4}, {-1, h, -4e4}, {-1, h, 4e4}, {-1, 0, 4e4}));
    const double lune = kPi - elevation_rad, length = kPi / 2 * std::sin(lune / 2) / lune;
    return {"wall, top at " + degrees(elevation_rad),
            std::move(walled),
            {0.5, 3, 1},
            {length * glm::dvec3(std::cos(lune / 2), std::sin(lune / 2), 0),
             kPi / 2 * (1 - std::max(2 * length - 1, 0.0))}};
}

constexpr std::array kRims{0.4, 0.8, 1.2}, kElevations{0.3, 0.9, 1.4};
constexpr std::array kScales{1e-3, 1.0, 1e3};

/// A view of its origin from above, a millionth of a radian wide.
Camera view_of(const ClosedForm& form) {
    return testing::looking(form.eye, {0, 0, 0}, 1e-6);
}

/// Tests each closed form at three scales.
class BentNormalsAtScale : public ::testing::TestWithParam<double> {
  protected:
    void expect_seen(const ClosedForm& form) const {
        SCOPED_TRACE(form.name);
        const testing::Similarity by{.scale = GetParam()};
        expect_closed_form(moved(form.scene, by), moved(view_of(form), by), form.expected);
    }
};

TEST_P(BentNormalsAtScale, OfAnOpenPlaneAreHalfTheNormal) {
    expect_seen(open_plane());
}

TEST_P(BentNormalsAtScale, BeforeAnEndlessWallLeanAwayFromIt) {
    expect_seen(endless_wall());
    EXPECT_NEAR(endless_wall().expected.cone_rad * kDegree, 52.7, 0.05);
}

TEST_P(BentNormalsAtScale, AtTheBottomOfAPitAreAsLongAsItsRimIsNarrow) {
    for (const double rim : kRims) expect_seen(pit(rim));
}

TEST_P(BentNormalsAtScale, BeforeAWallLieInTheMiddleOfTheLuneThatItLeaves) {
    for (const double elevation : kElevations) expect_seen(wall(elevation));
}

INSTANTIATE_TEST_SUITE_P(Scales, BentNormalsAtScale, ::testing::ValuesIn(kScales));

// Leaves cones.md: the means over a picture of 64 pixels with 1024 rays each, beside the closed forms.
TEST(BentNormals, LeaveATableOfClosedFormsAtThreeScales) {
    std::vector<ClosedForm> forms{open_plane(), endless_wall()};
    for (const double rim : kRims) forms.push_back(pit(rim));
    for (const double elevation : kElevations) forms.push_back(wall(elevation));
    std::string table = "| scene | scale | length of n' | expected | cone | expected | standard error |\n"
                        "|---|---|---|---|---|---|---|\n";
    for (const ClosedForm& form : forms) {
        for (const double scale : kScales) {
            const testing::Similarity by{.scale = scale};
            const Truth truth =
                bent_truth(moved(form.scene, by), moved(view_of(form), by), INFINITY, 1024, 1);
            double length = 0, cone = 0, squares = 0;
            const auto pixels = static_cast<double>(truth.bent_normal.size());
            for (std::size_t i = 0; i < truth.bent_normal.size(); ++i) {
                length += double{glm::length(truth.bent_normal.pixels[i])} / pixels;
                cone += double{truth.cone_angle_rad.pixels[i]} / pixels;
                squares += std::pow(double{truth.cone_error_rad.pixels[i]}, 2) / pixels;
            }
            const double error = std::sqrt(squares / pixels);
            EXPECT_NEAR(cone, form.expected.cone_rad, 5 * error + 1e-4) << form.name << ", scale " << scale;
            table += fmt::format("| {} | {:g} | {:.4f} | {:.4f} | {} | {} | {} |\n", form.name, scale, length,
                                 glm::length(form.expected.bent_normal), degrees(cone),
                                 degrees(form.expected.cone_rad), degrees(error));
        }
    }
    std::ofstream(testing::output_dir() / "cones.md") << table;
    std::printf("%s", table.c_str());
}

TEST(BentNormals, OfClosedPixelsAreTheirNormalsAndSaidToBeUnknown) {
    Scene closed = floor_only();
    testing::add(closed, testing::quad({-4, 1e-3, -4}, {4, 1e-3, -4}, {4, 1e-3, 4}, {-4, 1e-3, 4}));
    Camera inside = testing::looking({0, 5e-4, 1e-3}, {0, 0, 0}, 1e-3);
    inside.near = 1e-6;
    const Truth truth = bent_truth(closed, inside, 100, 64, 1);
    for (std::size_t i = 0; i < truth.bent_normal.size(); ++i) {
        EXPECT_EQ(truth.bent_normal.pixels[i], truth.hits.normal.pixels[i]);
        EXPECT_EQ(truth.cone_angle_rad.pixels[i], 0);
        EXPECT_FLOAT_EQ(truth.bent_error_rad.pixels[i], std::numbers::pi_v<float> / 2);
    }
}

TEST(BentNormals, OfProvenPixelsAreTheirNormals) {
    const CameraFrame frame(testing::looking({1, 5, 1}, {0, 0, 0}), 8, 8);
    TruthSettings settings;
    settings.extras.bent_normals = true;
    const Truth truth =
        ReferenceScene(floor_only()).trace(frame, {{Falloff::binary, 1, 0}}, settings, "open");
    EXPECT_EQ(truth.open_pixels, 64u);
    EXPECT_EQ(truth.bent_normal.at(3, 3), 0.5f * truth.hits.normal.at(3, 3));
    EXPECT_FLOAT_EQ(truth.cone_angle_rad.at(3, 3), std::numbers::pi_v<float> / 2);
    EXPECT_EQ(truth.bent_error_rad.at(3, 3), kProvenError);
}

TEST(BentNormals, ChangeNoBitOfTheVisibility) {
    const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.6, 0}), 48, 32);
    const ReferenceScene scene(testing::thicket());
    TruthSettings settings;
    settings.samples = 32;
    const std::vector<TruthQuery> queries{{Falloff::binary, 1, 0}};
    const Truth plain = scene.trace(frame, queries, settings, "plain");
    settings.extras.bent_normals = true;
    const Truth bent = scene.trace(frame, queries, settings, "bent");
    EXPECT_EQ(plain.visibility[0].pixels, bent.visibility[0].pixels);
    EXPECT_EQ(plain.standard_error[0].pixels, bent.standard_error[0].pixels);
}

/// Stated errors of few rays against their errors from a truth of many more.
struct Calibration {
    double root_mean_square = 0, tail = 0;
};

struct StatedErrors {
    Calibration angle, cone;
};

StatedErrors calibrate(const Scene& scene, const Camera& camera, int samples) {
    constexpr int kSize = 24;
    const Truth sure = bent_truth(scene, camera, 1, 4096, 99, kSize);
    double angles = 0, stated_angles = 0, cones = 0, stated_cones = 0;
    int angle_tail = 0, cone_tail = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Truth few = bent_truth(scene, camera, 1, samples, seed, kSize);
        for (std::size_t i = 0; i < few.bent_normal.size(); ++i) {
            // Where almost nothing is open, the error of a direction is not meaningful.
            if (few.hits.surface.pixels[i] == 0 || few.bent_error_rad.pixels[i] > 0.5F) continue;
            const double stated(few.bent_error_rad.pixels[i]), cone_stated(few.cone_error_rad.pixels[i]);
            const double angle = angle_between(few.bent_normal.pixels[i], sure.bent_normal.pixels[i]);
            const double cone(few.cone_angle_rad.pixels[i] - sure.cone_angle_rad.pixels[i]);
            angles += angle * angle;
            stated_angles += stated * stated;
            cones += cone * cone;
            stated_cones += cone_stated * cone_stated;
            angle_tail += angle > 3 * stated;
            cone_tail += std::abs(cone) > 3 * cone_stated;
            ++count;
        }
    }
    return {{std::sqrt(stated_angles / angles), 1.0 * angle_tail / count},
            {std::sqrt(stated_cones / cones), 1.0 * cone_tail / count}};
}

TEST(BentNormals, StateErrorsThatHold) {
    const std::vector<std::pair<const char*, Scene>> scenes{{"still life", testing::still_life()},
                                                            {"thicket", testing::thicket()}};
    for (const auto& [name, scene] : scenes) {
        for (const int samples : {16, 64, 192}) {
            const StatedErrors stated = calibrate(scene, testing::looking({2, 2, 3}, {0, 0.6, 0}), samples);
            const auto where = std::string(name) + " at " + std::to_string(samples);
            std::printf("%s: stated/true angle %.2f (tail %.4f), cone %.2f (tail %.4f)\n", where.c_str(),
                        stated.angle.root_mean_square, stated.angle.tail, stated.cone.root_mean_square,
                        stated.cone.tail);
            EXPECT_GT(stated.angle.root_mean_square, 0.9) << where;
            EXPECT_LT(stated.angle.root_mean_square, 1.6) << where;
            EXPECT_LT(stated.angle.tail, 0.01) << where;
            EXPECT_GT(stated.cone.root_mean_square, 0.9) << where;
            EXPECT_LT(stated.cone.root_mean_square, 2) << where;
            EXPECT_LT(stated.cone.tail, 0.01) << where;
        }
    }
}

TEST(UniformHemisphere, HasItsMomentsAndIsUnit) {
    glm::dvec3 mean(0);
    double z_squared = 0;
    constexpr int kSide = 64;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const glm::dvec3 d(uniform_hemisphere((static_cast<float>(i) + 0.5f) / kSide,
                                                  (static_cast<float>(j) + 0.5f) / kSide));
            EXPECT_NEAR(glm::length(d), 1, 1e-6);
            mean += d;
            z_squared += d.z * d.z;
        }
    }
    EXPECT_NEAR(glm::distance(mean / double{kSide * kSide}, glm::dvec3(0, 0, 0.5)), 0, 1e-3);
    EXPECT_NEAR(z_squared / (kSide * kSide), 1.0 / 3, 1e-3);
}

}  // namespace
}  // namespace aoscore
