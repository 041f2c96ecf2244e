#include "oracle_cases.h"

#include "oracle_formulas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::formula {

using glm::dvec2;
using glm::dvec3;

namespace {

constexpr double kPi = std::numbers::pi;

/// Points in the hemisphere's volume, whose occluders count less the farther they lie in depth.
double fading_point_test(const Field& f, const Point& p) {
    return point_test(
        f, p, [](Random& r) { return in_volume(oracle::hemisphere_direction(r), r); },
        [&](const dvec3&, double z) { return smooth_step(0, 1, kRadius / std::abs(p.p.z - z)); });
}

}  // namespace

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"crytek",
         "crytek-ssao",
         {{"samples", 256}, {"radius", kRadius}, {"kernel_scale", "none"}},
         [](const Field& f, const Point& p) {
             return point_test(
                 f, p, [](Random& r) { return oracle::cube_direction(r) * oracle::unit(r); },
                 [&](const dvec3&, double z) { return std::abs(z - p.p.z) < kRadius ? 1.0 : 0.0; }, 0.025);
         },
         0.02,
         24},
        {"crytek_fade",
         "crytek-ssao",
         {{"samples", 256},
          {"radius", kRadius},
          {"kernel_scale", "none"},
          {"range_check", "fade"},
          {"bias", 0.0}},
         [](const Field& f, const Point& p) {
             const glm::dmat3 frame = oracle::basis(p.n);
             return oracle::mean(60000, [&](Random& r) {
                 const dvec3 s = p.p + frame * (oracle::cube_direction(r) * oracle::unit(r)) * kRadius;
                 const double z = f.z(s.x, s.y), open = z < s.z ? 1.0 : 0.0;
                 return open + (0.5 - open) * std::clamp((-p.p.z - -z) / -z, 0.0, 1.0);
             });
         },
         0.02,
         24},
        {"starcraft",
         "starcraft-ssao",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) {
             return point_test(
                 f, p, [](Random& r) { return in_volume(oracle::hemisphere_direction(r), r); },
                 [&](const dvec3&, double z) { return 1 - std::clamp((-p.p.z + z) / -z, 0.0, 1.0); });
         },
         0.02,
         16},
        {"ssao", "ssao", {{"samples", 256}, {"radius", kRadius}}, fading_point_test, 0.02, 16},
        {"sd_ssao", "sd-ssao", {{"samples", 256}, {"radius", kRadius}}, fading_point_test, 0.02, 16},
        {"hemisphere",
         "hemisphere-ssao",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) { return point_test(f, p, oracle::cosine_direction, always); },
         0.02,
         16},
        {"monte_carlo",
         "monte-carlo-points",
         {{"samples", 256}, {"radius", kRadius}, {"falloff", "quadratic"}},
         [](const Field& f, const Point& p) {
             // The mean of the cosine over the hemisphere is one half.
             return point_test(
                 f, p, [](Random& r) { return in_volume(oracle::hemisphere_direction(r), r); },
                 [&](const dvec3& o, double z) {
                     return std::abs(z - p.p.z) < kRadius ? 2 * (1 - glm::dot(o, o)) * o.z / glm::length(o)
                                                          : 0.0;
                 });
         },
         0.02,
         16},
        {"n8ao",
         "n8ao",
         {{"samples", 256}, {"radius", kRadius}, {"full_radius_log2", 16}},
         [](const Field& f, const Point& p) {
             const glm::dmat3 frame = oracle::basis(p.n);
             return 1 - oracle::mean(60000, [&](Random& r) {
                        const dvec3 s =
                            p.p + frame * oracle::cosine_direction(r) * (oracle::unit(r) * kRadius);
                        const double before = f.z(s.x, s.y) - s.z;
                        return before > 0 ? smooth_step(0, 1, 0.2 * kRadius / before) : 0.0;
                    });
         },
         0.02,
         16},
        {"alchemy",
         "alchemy",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) { return alchemy(f, p, 0.128, 1.56); },
         0.015,
         12},
        {"alchemy_spiral",
         "alchemy-spiral",
         {{"samples", 9}, {"radius", kRadius}},
         [](const Field& f, const Point& p) {
             // These are the shader's exact taps, whose rotation is a function of the pixel (y runs down).
             const double column = p.p.x / kPixel + kSize / 2.0, row = kSize / 2.0 - p.p.y / kPixel;
             const double turn = 2.3734372915 * column + 3.58540627421 * row;
             double sum = 0;
             for (int i = 0; i < 9; ++i) {
                 const double alpha = (i + 0.5) / 9, angle = 2 * kPi * alpha + turn;
                 const dvec2 at = alpha * kRadius * dvec2(std::cos(angle), -std::sin(angle));
                 const dvec3 v = oracle::surface(f, p.p.x + at.x, p.p.y + at.y) - p.p;
                 sum += std::max(0.0, glm::dot(v, p.n) + p.p.z * 0.001) / (glm::dot(v, v) + 1e-4);
             }
             return std::pow(std::max(0.0, 1 - 2 * 0.128 / 9 * sum), 1.56);
         },
         0.03,
         1},
        {"sao",
         "sao",
         {{"samples", 256}, {"turns", 37}, {"radius", kRadius}, {"intensity", 0.1}, {"full_radius_log2", 16}},
         sao,
         0.02,
         12},
        {"cacao", "cacao", {{"pairs", 128}, {"radius", kRadius}}, cacao, 0.02, 12},
        {"sphere_caps", "sphere-caps", {{"samples", 256}, {"radius", kRadius}}, sphere_caps, 0.04, 16},
        {"volumetric_sphere",
         "volumetric-sphere",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) { return volumetric(f, p, false); },
         0.015,
         12},
        {"volumetric_hemisphere",
         "volumetric-hemisphere",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) { return volumetric(f, p, true); },
         0.015,
         12},
        {"tangent_sphere",
         "tangent-sphere",
         {{"samples", 256}, {"radius", kRadius}},
         tangent_sphere,
         0.015,
         12},
        {"hbao",
         "hbao",
         {{"directions", 64}, {"steps", 32}, {"radius", kRadius}, {"bias", 0.3}, {"threshold", 3.1416}},
         [](const Field& f, const Point& p) { return hbao(f, p, 0.3); },
         0.015,
         8},
        {"sd_hbao",
         "sd-hbao",
         {{"directions", 32}, {"steps", 32}, {"radius", kRadius}, {"bias", 0.3}, {"threshold", 3.1416}},
         [](const Field& f, const Point& p) { return hbao(f, p, 0.3); },
         0.015,
         4},
        {"hbao_hussain",
         "hbao-hussain",
         {{"directions", 64}, {"steps", 20}, {"radius", kRadius}, {"step_uv", 2.5 / kSize}},
         [](const Field& f, const Point& p) { return hbao_hussain(f, p, 2.5 * kPixel, 20); },
         0.02,
         1},
        {"hbao_plus",
         "hbao-plus",
         {{"directions", 64}, {"steps", 32}, {"radius", kRadius}},
         hbao_plus,
         0.015,
         8},
        {"sd_hbao_plus",
         "sd-hbao-plus",
         {{"directions", 32}, {"steps", 32}, {"radius", kRadius}},
         hbao_plus,
         0.015,
         4},
        {"gtao",
         "gtao",
         {{"slices", 32}, {"steps", 60}, {"radius", kRadius}, {"step_power", 1.0}},
         gtao,
         0.02,
         4},
        {"sd_gtao",
         "sd-gtao",
         {{"slices", 32}, {"steps", 60}, {"radius", kRadius}, {"step_power", 1.0}},
         gtao,
         0.02,
         4},
        {"xegtao",
         "xegtao",
         {{"slices", 32},
          {"steps", 80},
          {"radius", kRadius},
          {"step_power", 1.0},
          {"mip_offset", 16.0},
          {"acos", "exact"},
          {"outside", "of_run"}},
         xegtao,
         0.04,
         4},
        {"bitmask",
         "visibility-bitmask",
         {{"slices", 32}, {"steps", 60}, {"radius", kRadius}, {"step_power", 1.0}, {"thickness", 1000.0}},
         uniform_sectors,
         0.03,
         4},
        {"sd_bitmask",
         "sd-bitmask",
         {{"slices", 32}, {"steps", 60}, {"radius", kRadius}, {"step_power", 1.0}, {"thickness", 1000.0}},
         uniform_sectors,
         0.03,
         4},
        {"bitmask_cosine",
         "visibility-bitmask",
         {{"slices", 32},
          {"steps", 60},
          {"radius", kRadius},
          {"step_power", 1.0},
          {"thickness", 1000.0},
          {"weights", "cosine"}},
         gtao,
         0.03,
         4},
        {"ray_march",
         "ray-march",
         {{"directions", 256}, {"steps", 100}, {"radius", kRadius}, {"occluders", "solid"}},
         ray_march,
         0.03,
         1},
    };
    return all;
}

}  // namespace aoscore::testing::formula
