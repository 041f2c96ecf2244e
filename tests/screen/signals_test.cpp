// Tests signals beside visibility: asking for them changes nothing else, and bent normals and cones are right
// where they are known.
#include "core/error.h"
#include "core/signal.h"
#include "hand_made.h"
#include "relief.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// A mean open direction and a cone's half angle.
struct Cone {
    glm::dvec3 bent_normal{0};
    double half_angle = 0;
};

Cone cone_at(const MethodOutput& output, int x, int y) {
    const SignalImage &bent = output.signals.at("bent_normal"), &cone = output.signals.at("cone_angle");
    return {{bent[0].at(x, y), bent[1].at(x, y), bent[2].at(x, y)}, static_cast<double>(cone[0].at(x, y))};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double cone_of_length(const glm::dvec3& mean) {
    return kPi / 2 * (1 - std::clamp(2 * glm::length(mean) - 1, 0.0, 1.0));
}

class Signals : public ::testing::Test {
  protected:
    MethodRequest request(const std::string& id, const ParameterValues& settings = {}) const {
        MethodRequest request;
        request.method = &find_method(methods_, id);
        request.parameters = request.method->values("default", settings);
        request.border = Border::clamp;
        request.signals = request.method->passes.back().outputs;
        return request;
    }
    std::vector<const MethodDescriptor*> giving() const {
        std::vector<const MethodDescriptor*> methods;
        for (const MethodDescriptor& method : methods_) {
            if (!method.passes.back().outputs.empty()) methods.push_back(&method);
        }
        return methods;
    }

    ScreenRenderer renderer_;
    std::vector<MethodDescriptor> methods_ = load_methods();
};

TEST_F(Signals, AreGivenByAtLeastTheMethodsOfVermeerGtaoAndTheBitmask) {
    for (const char* id : {"ssao", "hbao", "hbao-plus", "gtao", "visibility-bitmask"}) {
        EXPECT_TRUE(find_method(methods_, id).gives("bent_normal")) << id;
        EXPECT_TRUE(find_method(methods_, id).gives("cone_angle")) << id;
    }
}

TEST_F(Signals, ChangeNoBitOfTheVisibilityAndAreZeroOnBackground) {
    renderer_.set_scene(corner_scene());
    renderer_.draw_gbuffer(CameraFrame(corner_camera(), 160, 90), gbuffer_inputs());
    const Mask surface = renderer_.read_gbuffer().surface;
    for (const MethodDescriptor* method : giving()) {
        for (const std::string& preset : drawn_presets(*method)) {
            MethodRequest asked = request(method->id);
            asked.parameters = method->values(preset);
            MethodRequest plain = asked;
            plain.signals.clear();
            const MethodOutput with = renderer_.run(asked), without = renderer_.run(plain);
            EXPECT_EQ(with.raw.pixels, without.raw.pixels) << method->id << "/" << preset;
            EXPECT_TRUE(without.signals.empty());
            for (std::size_t i = 0; i < surface.size(); ++i) {
                for (const auto& [id, image] : with.signals) {
                    const Signal& row = signal(id);
                    for (const ImageF& plane : image) {
                        const double value(plane.pixels[i]);
                        ASSERT_TRUE(surface.pixels[i] != 0 || value == 0) << method->id << " " << id;
                        ASSERT_TRUE(value >= row.low - 1e-5 && value <= row.high + 1e-5)
                            << method->id << "/" << preset << " " << id << ": " << value;
                    }
                }
            }
        }
    }
}

TEST_F(Signals, MayBeAskedForOneByOne) {
    renderer_.set_scene(corner_scene());
    renderer_.draw_gbuffer(CameraFrame(corner_camera(), 64, 36), gbuffer_inputs());
    for (const MethodDescriptor* method : giving()) {
        const MethodOutput all = renderer_.run(request(method->id));
        for (const std::string& id : method->passes.back().outputs) {
            MethodRequest one = request(method->id);
            one.signals = {id};
            const MethodOutput output = renderer_.run(one);
            ASSERT_EQ(output.signals.size(), 1u);
            for (std::size_t plane = 0; plane < all.signals.at(id).size(); ++plane)
                EXPECT_EQ(output.signals.at(id)[plane].pixels, all.signals.at(id)[plane].pixels);
        }
    }
}

TEST_F(Signals, ThatAMethodDoesNotGiveAreRefusedInWords) {
    renderer_.set_scene(corner_scene());
    renderer_.draw_gbuffer(CameraFrame(corner_camera(), 32, 18), gbuffer_inputs());
    MethodRequest asked = request("alchemy");
    asked.signals = {"bent_normal"};
    EXPECT_THROW(renderer_.run(asked), Error);
    asked = request("gtao");
    asked.resolution = Resolution::half;
    EXPECT_THROW(renderer_.run(asked), Error);
    EXPECT_THROW(signal("bent"), Error);
}

/// A method at settings for which its bent normal has a closed form.
struct Case {
    std::string name, method;
    ParameterValues settings;
    /// The cone for a horizon of this elevation over the plane by azimuth, seen from above.
    std::function<Cone(const std::function<double(double)>& elevation)> expected;
    double tolerance_rad;
};

constexpr int kAzimuths = 2000;

/// The mean over open directions, weighted by a power of the cosine to the plane's normal.
Cone open_mean(const std::function<double(double)>& elevation, int power) {
    constexpr int kAngles = 1000;
    glm::dvec3 sum(0);
    double weight = 0;
    for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = 2 * kPi * (i + 0.5) / kAzimuths, open = kPi / 2 - elevation(azimuth);
        for (int j = 0; j < kAngles; ++j) {
            const double zenith = open * (j + 0.5) / kAngles;
            const double part = open * std::sin(zenith) * std::pow(std::cos(zenith), power);
            sum += part * glm::dvec3(std::sin(zenith) * glm::dvec2(std::cos(azimuth), std::sin(azimuth)),
                                     std::cos(zenith));
            weight += part;
        }
    }
    return {sum / weight, cone_of_length(sum / weight)};
}

/// Vermeer's mean of normals turned away from each horizon.
Cone turned_mean(const std::function<double(double)>& elevation) {
    Cone mean;
    for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = 2 * kPi * (i + 0.5) / kAzimuths, rise = elevation(azimuth);
        mean.bent_normal +=
            glm::dvec3(-std::sin(rise) * glm::dvec2(std::cos(azimuth), std::sin(azimuth)), std::cos(rise)) /
            double{kAzimuths};
        mean.half_angle += (kPi / 2 - rise) / kAzimuths;
    }
    return mean;
}

/// The published cone of GTAO: cos a = sqrt(1 - V).
Cone cosine_mean(const std::function<double(double)>& elevation) {
    double visibility = 0;
    for (int i = 0; i < kAzimuths; ++i)
        visibility += std::pow(std::cos(elevation(2 * kPi * (i + 0.5) / kAzimuths)), 2) / kAzimuths;
    return {open_mean(elevation, 1).bent_normal, std::acos(std::sqrt(1 - std::min(visibility, 1.0)))};
}

std::vector<Case> cases(bool endless) {
    const double radius = endless ? 4 : 1;
    const int steps = endless ? 400 : 100;
    const ParameterValues slices = {
        {"slices", 32}, {"steps", steps}, {"step_power", 1.0}, {"radius", radius}};
    const auto with = [&](ParameterValues settings, const std::string& id, const ParameterValue& value) {
        settings[id] = value;
        return settings;
    };
    const ParameterValues march = {{"directions", 64}, {"steps", steps}, {"radius", radius}, {"bias", 0.0}};
    const auto uniform = [](const auto& elevation) { return open_mean(elevation, 0); };
    return {
        {"gtao, uniform", "gtao", with(slices, "bent_weights", "uniform"), uniform, 0.015},
        {"gtao, cosine", "gtao", slices, cosine_mean, 0.015},
        // 32 sectors make a horizon precise to 5.6 degrees.
        {"visibility-bitmask", "visibility-bitmask", with(slices, "thickness", 1000.0), uniform, 0.05},
        {"hbao", "hbao", with(march, "threshold", 3.1416), turned_mean, 0.015},
        {"hbao-plus", "hbao-plus", march, turned_mean, 0.015},
    };
}

TEST_F(Signals, BentNormalsAndConesOfWallsAndPitsAreTheirClosedForms) {
    std::ofstream table(output_dir() / "cones.md");
    table << "| surface | method | bent normal, degrees off | cone, degrees | closed form "
             "|\n|---|---|---|---|---|\n";
    std::vector<Relief> reliefs;
    for (const double ratio : {0.5, 1.0, 2.0}) reliefs.push_back(wall(ratio, 8));
    for (const double degrees : {30.0, 60.0}) reliefs.push_back(pit(degrees));
    for (const Relief& relief : reliefs) {
        renderer_.set_scene(relief.scene);
        renderer_.draw_gbuffer(from_above(relief.width, relief.height), gbuffer_inputs());
        for (const Case& tested : cases(relief.endless)) {
            const MethodOutput output = renderer_.run(request(tested.method, tested.settings));
            Cone mean;
            for (const glm::ivec2& at : relief.pixels) {
                const Cone one = cone_at(output, at.x, at.y);
                mean.bent_normal += one.bent_normal / static_cast<double>(relief.pixels.size());
                mean.half_angle += one.half_angle / static_cast<double>(relief.pixels.size());
            }
            // The occluder lies at azimuth 0, to the left.
            const Cone expected =
                tested.expected([&](double azimuth) { return relief.elevation(kPi - azimuth); });
            const double off = angle_between(mean.bent_normal, expected.bent_normal);
            EXPECT_LT(off, tested.tolerance_rad) << relief.name << ": " << tested.name;
            EXPECT_NEAR(mean.half_angle, expected.half_angle, 2 * tested.tolerance_rad)
                << relief.name << ": " << tested.name;
            table << "| " << relief.name << " | " << tested.name << " | " << off * 180 / kPi << " | "
                  << mean.half_angle * 180 / kPi << " | " << expected.half_angle * 180 / kPi << " |\n";
        }
    }
}

TEST_F(Signals, TheUniformMeanOfAPitIsVermeersClosedForm) {
    // |n'| = (1 + cos r)/2, and the lune before a wall: pi/2 sin(t/2)/t.
    const Cone in_pit = open_mean([](double) { return kPi / 3; }, 0);
    EXPECT_NEAR(glm::length(in_pit.bent_normal), (1 + std::cos(kPi / 6)) / 2, 1e-5);
    const Cone before_wall = open_mean([](double a) { return std::atan(std::max(std::cos(a), 0.0)); }, 0);
    const double lune = kPi * 3 / 4;
    EXPECT_NEAR(glm::length(before_wall.bent_normal), kPi / 2 * std::sin(lune / 2) / lune, 1e-4);
}

// Takes the pixels' mean over many random samples, on planes that face the viewer and planes that turn away.
TEST_F(Signals, OfAnOpenPlaneAreItsNormalAndTheHemisphere) {
    for (const double tilt : {0.0, 0.5, 1.0}) {
        const glm::dvec3 normal(std::sin(tilt), 0, std::cos(tilt));
        renderer_.set_scene(plane_scene({0, 0, -6}, normal, 200));
        renderer_.draw_gbuffer(CameraFrame(front_camera(), 64, 36), gbuffer_inputs());
        for (const MethodDescriptor* method : giving()) {
            ParameterValues settings;
            if (const Parameter* slices = method->find_parameter("slices"))
                settings["slices"] = std::min(64.0, slices->highest);
            // A texel has one depth on a slope, so that without a bias it hides points of SSAO.
            if (method->find_parameter("samples") != nullptr) settings = {{"samples", 256}, {"bias", 0.05}};
            const Cone cone = cone_at(renderer_.run(request(method->id, settings)), 32, 18);
            EXPECT_LT(angle_between(cone.bent_normal, normal), 0.03) << method->id << " at " << tilt;
            EXPECT_NEAR(cone.half_angle, kPi / 2, 0.06) << method->id << " at " << tilt;
        }
    }
}

TEST_F(Signals, BentNormalsLeanAwayFromAWall) {
    const Relief relief = wall(2, 8);
    renderer_.set_scene(relief.scene);
    renderer_.draw_gbuffer(from_above(relief.width, relief.height), gbuffer_inputs());
    for (const MethodDescriptor* method : giving()) {
        ParameterValues settings{{"radius", 2.0}};
        if (method->find_parameter("samples") != nullptr) settings["samples"] = 256;
        const Cone cone = cone_at(renderer_.run(request(method->id, settings)), 60, 4);
        EXPECT_GT(cone.bent_normal.x, 0.05) << method->id << ": the wall is to the left";
        EXPECT_LT(cone.half_angle, kPi / 2) << method->id;
    }
}

}  // namespace
}  // namespace aoscore::testing
