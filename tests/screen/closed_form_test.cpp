#include "fidelity_table.h"
#include "hand_made.h"
#include "oracle_cases.h"
#include "oracle_formulas.h"
#include "relief.h"
#include "scene/builtin/closed_forms.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPixel_m = formula::kPixel;
constexpr double kFloor = Relief::kFloor;

// A point beside a sphere that floats over the floor. Seen from above, the space below its upper half counts
// as solid: in a slice, all under the upper tangent of the circle in which the slice cuts the sphere.
Relief sphere() {
    constexpr int kSize = 181, kRings = 96, kSectors = 192;
    constexpr double kRadius = 0.25, kHeight = 0.32, kDistance = 0.4;
    Relief relief{"sphere beside",
                  plane_scene({0, 0, kFloor}, {0, 0, 1}, 50),
                  kSize,
                  kSize,
                  {{kSize / 2, kSize / 2}},
                  {}};
    Mesh mesh;
    for (int ring = 0; ring <= kRings; ++ring) {
        const double polar = kPi * ring / kRings;
        for (int sector = 0; sector < kSectors; ++sector) {
            const double angle = 2 * kPi * sector / kSectors;
            mesh.positions.emplace_back(kDistance + kRadius * std::sin(polar) * std::cos(angle),
                                        kRadius * std::sin(polar) * std::sin(angle),
                                        kFloor + kHeight + kRadius * std::cos(polar));
            if (ring == kRings) continue;
            const auto at = [&](int r, int s) { return static_cast<unsigned>(r * kSectors + s % kSectors); };
            mesh.triangles.emplace_back(at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1));
            mesh.triangles.emplace_back(at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1));
        }
    }
    relief.scene.instances.push_back({static_cast<int>(relief.scene.meshes.size()), glm::dmat4(1.0)});
    relief.scene.meshes.push_back(std::move(mesh));
    relief.elevation = [](double azimuth) {
        const double across = kDistance * std::sin(azimuth), ahead = kDistance * std::cos(azimuth);
        if (ahead < 0 || std::abs(across) >= kRadius) return 0.0;
        const double cut = std::sqrt(kRadius * kRadius - across * across);
        return std::min(std::atan2(kHeight, ahead) + std::asin(cut / std::hypot(kHeight, ahead)), kPi / 2);
    };
    return relief;
}

// A horizon-based method, its visibility for a horizon, and the tolerance.
struct HorizonMethod {
    std::string name, method, source;
    ParameterValues settings;
    std::function<double(double elevation)> open;  // visibility of one azimuth, whose mean is V
    double tolerance;
};

double cosine_weighted(double e) {
    return std::pow(std::cos(e), 2);
}

// The radius is 4 m, beyond which occluders count for less than the tolerance, with a step a pixel. The rays
// of the march are shorter, but longer than the walls are high.
std::vector<HorizonMethod> horizon_methods(bool endless) {
    const double radius = endless ? 4 : 1;
    const int steps = endless ? 400 : 100;
    const ParameterValues gtao = {{"slices", 32}, {"steps", steps}, {"step_power", 1.0}, {"radius", radius}};
    const auto bitmask = [&](const char* weights) {
        ParameterValues settings = gtao;
        settings["thickness"] = 1000.0;
        settings["weights"] = weights;
        return settings;
    };
    const ParameterValues hbao = {{"directions", 64}, {"steps", steps},      {"radius", radius},
                                  {"bias", 0.0},      {"threshold", 3.1416}, {"falloff", "none"}};
    const auto uniform_sectors = [](double e) { return 1 - 2 * e / kPi; };
    return {
        {"gtao", "gtao", "exact", gtao, cosine_weighted, 0.015},
        // 32 sectors make a horizon precise to 5.6 degrees.
        {"visibility-bitmask, cosine", "visibility-bitmask", "exact", bitmask("cosine"), cosine_weighted,
         endless ? 0.015 : 0.05},
        {"visibility-bitmask, uniform", "visibility-bitmask", "uniform sectors", bitmask("uniform"),
         uniform_sectors, endless ? 0.015 : 1.0 / 32 + 0.01},
        {"hbao", "hbao", "uniform hemisphere", hbao, [](double e) { return 1 - std::sin(e); }, 0.015},
        {"ray-march",
         "ray-march",
         "exact",
         {{"directions", 256},
          {"steps", endless ? 250 : 100},
          {"radius", endless ? 2.5 : 1.0},
          {"occluders", "solid"}},
         cosine_weighted,
         0.015},
        {"line-sweep", "line-sweep", "exact", {{"directions", 64}}, cosine_weighted, 0.015},
    };
}

double mean_over_azimuths(const Relief& relief, const std::function<double(double)>& open) {
    constexpr int kCount = 20000;
    double sum = 0;
    for (int i = 0; i < kCount; ++i) sum += open(relief.elevation(2 * kPi * (i + 0.5) / kCount));
    return sum / kCount;
}

class ClosedForms : public ::testing::Test {
  protected:
    const MethodDescriptor& method(const std::string& id) const { return find_method(methods_, id); }

    double read(const Relief& relief, const HorizonMethod& tested) {
        renderer_.set_scene(relief.scene);
        renderer_.draw_gbuffer(from_above(relief.width, relief.height), gbuffer_inputs());
        MethodRequest request;
        request.method = &method(tested.method);
        request.parameters = request.method->values("default", tested.settings);
        // In an orthographic view, surfaces at the border go on endlessly.
        request.border = Border::clamp;
        const ImageF image = renderer_.run(request).raw;
        double sum = 0;
        for (const glm::ivec2& at : relief.pixels) sum += static_cast<double>(image.at(at.x, at.y));
        return sum / static_cast<double>(relief.pixels.size());
    }

    // The mean over a column's pixels, which are all alike, and over seeds; for a case of one seed, a single
    // pixel.
    double read(const formula::Case& tested) {
        constexpr int kMiddle = formula::kSize / 2, kRows = 20, kSeeds = 4;
        const bool alone = tested.seeds == 1;
        MethodRequest request;
        request.method = &method(tested.method);
        request.parameters = request.method->values("default", tested.settings);
        request.uniform_form = !alone;
        double sum = 0;
        const int seeds = alone ? 1 : kSeeds, rows = alone ? 0 : kRows;
        for (request.seed = 1; request.seed <= static_cast<std::uint64_t>(seeds); ++request.seed) {
            const ImageF image = renderer_.run(request).raw;
            for (int y = kMiddle - rows; y <= kMiddle + rows; ++y)
                sum += static_cast<double>(image.at(kMiddle, y));
        }
        return sum / (seeds * (2 * rows + 1));
    }

    ScreenRenderer renderer_;
    std::vector<MethodDescriptor> methods_ = load_methods();
};

// The part of the cosine-weighted hemisphere beyond a wall at c = d/R: a segment of the unit disc.
double segment(double c) {
    return c < 1 ? 1 - closed_form::wall_visibility_cutoff(c, 1) : 0;
}

// N8AO beside a wall of height 1: points behind it count less the deeper they lie under its top. This is the
// mean over their distance and the hemisphere's disc.
double n8ao_beside_the_wall(double c) {
    constexpr int kCells = 120;
    double sum = 0, count = 0;
    for (int i = 0; i < kCells; ++i) {
        for (int j = 0; j < kCells; ++j) {
            const double x = (2 * i + 1.0) / kCells - 1, y = (2 * j + 1.0) / kCells - 1,
                         z2 = 1 - x * x - y * y;
            if (z2 < 0) continue;
            for (int k = 0; k < kCells; ++k) {
                const double t = (k + 0.5) / kCells, below = 1 - t * std::sqrt(z2);
                sum += t * x > c ? formula::smooth_step(0, 1, 0.2 / below) : 0;
                ++count;
            }
        }
    }
    return 1 - sum / count;
}

// V of the point tests and line samples beside a wall of the height of the radius, at c = d/R: 1 - the part
// of their points or lines beyond it.
std::map<std::string, double> beside_the_cut_off_wall(double c) {
    const auto cap = [](double x) {
        return x < 1 ? std::pow(1 - x, 2) * (2 + x) / 4 : 0.0;
    };  // share of a ball's volume
    const double faded = formula::kRadius / (-kFloor - formula::kRadius);
    return {
        {"hemisphere", 1 - segment(c)},
        {"n8ao", n8ao_beside_the_wall(c)},
        {"ssao", 1 - cap(c)},
        {"starcraft", 1 - cap(c) * (1 - faded)},
        {"volumetric_sphere", 1 - cap(c)},
        {"volumetric_hemisphere", 1 - cap(c)},
        {"tangent_sphere", 1 - cap(2 * c)},
        {"ray_march", 1 - segment(c)},
    };
}

// The whole table is one test, so that it is written to one file: fidelity.md.
TEST_F(ClosedForms, AndTheMethodsOwnBiasesAreRead) {
    FidelityTable table;
    EXPECT_NEAR(mean_over_azimuths(wall(2, 8), cosine_weighted), closed_form::wall_visibility(1, 2), 1e-6);
    EXPECT_NEAR(mean_over_azimuths(pit(30), cosine_weighted), closed_form::pit_visibility(kPi / 6), 1e-6);
    std::vector<Relief> reliefs;
    for (const double k : {0.5, 1.0, 2.0}) {
        reliefs.push_back(wall(k, 8));
        // A line sweep has no border to clamp, and needs to see the wall's length.
        reliefs.push_back(wall(k, 512));
    }
    for (const double degrees : {30.0, 60.0}) reliefs.push_back(pit(degrees));
    reliefs.push_back(sphere());
    for (const Relief& relief : reliefs) {
        for (const HorizonMethod& tested : horizon_methods(relief.endless)) {
            if (relief.endless && (tested.method == "line-sweep") != (relief.height > 8)) continue;
            table.add(relief.name, tested.name, tested.source, read(relief, tested),
                      mean_over_azimuths(relief, tested.open), tested.tolerance);
        }
    }

    // Every estimator is given planes and a wall within its radius.
    constexpr double kEdge = 19.5 * kPixel_m, kHeight = formula::kRadius;
    const auto closed = beside_the_cut_off_wall(kEdge / formula::kRadius);
    for (const double degrees : {30.0, 60.0, -1.0}) {
        const double slope = degrees > 0 ? std::tan(degrees * kPi / 180) : 0;
        const bool is_wall = degrees < 0;
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 0, 1));
        Scene scene = plane_scene({0, 0, kFloor}, normal, 50);
        if (is_wall) add_quad(scene, {-50, -50, kFloor + kHeight}, {50 - kEdge, 0, 0}, {0, 100, 0});
        renderer_.set_scene(scene);
        renderer_.draw_gbuffer(from_above(formula::kSize, formula::kSize), gbuffer_inputs());
        const oracle::Field field{
            [&](double x, double) { return kFloor + slope * x + (is_wall && x < -kEdge ? kHeight : 0.0); },
            kPixel_m};
        for (const formula::Case& tested : formula::cases()) {
            const auto known = is_wall ? closed.find(tested.name) : closed.end();
            const bool has_closed_form = known != closed.end();
            const double expected =
                has_closed_form ? known->second : tested.expected(field, {{0, 0, kFloor}, normal});
            table.add(is_wall ? "wall within reach, c = 0.49" : fmt::format("plane, {:g}°", degrees),
                      tested.name, has_closed_form ? "closed form" : "the paper's formula", read(tested),
                      expected, std::max(tested.tolerance, 0.03));
        }
    }
    table.write(output_dir() / "fidelity.md");
}

}  // namespace
}  // namespace aoscore::testing
