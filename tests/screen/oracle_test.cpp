#include "oracle.h"

#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

using glm::dvec2;
using glm::dvec3;
using oracle::Field;
using oracle::Point;
using oracle::Random;

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 0.4;
constexpr double kPixel = 0.01;
constexpr int kSize = 121;

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// A slope, a bump, a hollow and a steep step, 6 m away. No texel of it is where a formula changes abruptly.
double terrain(double x, double y) {
    const double bump = 0.18 * std::exp(-((x + 0.2) * (x + 0.2) + (y - 0.15) * (y - 0.15)) / 0.02);
    const double hollow = -0.15 * std::exp(-((x - 0.15) * (x - 0.15) + (y + 0.2) * (y + 0.2)) / 0.015);
    return -6 + 0.25 * x + bump + hollow + 0.2 * smooth_step(0.2, 0.26, y + 0.3 * x);
}

Scene terrain_scene() {
    // Wider than the picture and twice as fine.
    constexpr int kCells = 2 * kSize + 80;
    const double extent = kCells * kPixel / 4;
    Scene scene = empty_scene();
    Mesh mesh;
    for (int j = 0; j <= kCells; ++j) {
        for (int i = 0; i <= kCells; ++i) {
            const double x = -extent + i * kPixel / 2, y = -extent + j * kPixel / 2;
            mesh.positions.emplace_back(x, y, terrain(x, y));
        }
    }
    const auto at = [](int i, int j) { return static_cast<unsigned>(j * (kCells + 1) + i); };
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    return scene;
}

// The pixels that are compared: far enough from the border for every radius.
const std::vector<glm::ivec2> kPixels = {{60, 60}, {46, 52}, {70, 76}, {72, 45}, {52, 66}, {64, 48}};

// A method at high quality, what its shader's mean over seeds must be, and how near.
struct Case {
    const char* name;
    const char* method;
    ParameterValues settings;
    std::function<double(const Field&, const Point&)> expected;
    double tolerance;
    int seeds;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

// V = 1 - mean of what hides, over points P + frame · draw() · R.
double point_test(const Field& field, const Point& point, const std::function<dvec3(Random&)>& draw,
                  const std::function<double(const dvec3& offset, double surface_z)>& weight,
                  double bias = 0) {
    const glm::dmat3 frame = oracle::basis(point.n);
    return 1 - oracle::mean(60000, [&](Random& random) {
               const dvec3 offset = draw(random);
               const dvec3 s = point.p + frame * offset * kRadius;
               return oracle::hidden(field, s, bias) ? weight(offset, field.z(s.x, s.y)) : 0.0;
           });
}
double always(const dvec3&, double) {
    return 1;
}

// A radius evenly in volume.
dvec3 in_volume(const dvec3& direction, Random& random) {
    return direction * std::cbrt(oracle::unit(random));
}

double alchemy(const Field& field, const Point& point, double sigma, double kappa) {
    const double mean = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        return std::max(0.0, glm::dot(v, point.n) + point.p.z * 0.001) / (glm::dot(v, v) + 1e-4);
    });
    return std::pow(std::max(0.0, 1 - 2 * sigma * mean), kappa);
}

double sao(const Field& field, const Point& point) {
    // The spiral's radius is even in its length, not in the disc's area: weight 1/r.
    double weights = 0;
    const double sum = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const double r = std::max(glm::length(dvec2(v)), 1e-4), d2 = glm::dot(v, v);
        weights += 1 / r;
        return std::pow(std::max(kRadius * kRadius - d2, 0.0), 3) *
               std::max((glm::dot(v, point.n) - 0.01) / (d2 + 0.01), 0.0) / r;
    });
    const double count = 400 * 400 * kPi / 4;
    return std::max(0.0, 1 - 5 * 0.1 / std::pow(kRadius, 6) * sum / (weights / count));
}

double cacao(const Field& field, const Point& point) {
    double weights = 0;
    const double sum = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const double d2 = glm::dot(v, v),
                     weight = 0.4 + 0.6 * std::clamp(2 - std::max(v.z, 0.0) / kRadius, 0.0, 1.0);
        weights += weight;
        return weight * std::max(0.0, glm::dot(v, point.n) / std::sqrt(d2) - 0.06) *
               std::max(0.0, 1 - d2 / (kRadius * kRadius));
    });
    const double count = 400 * 400 * kPi / 4;
    return std::pow(1 - std::min(4.3 * sum / (weights / count), 0.98), 1.5);
}

double sphere_caps(const Field& field, const Point& point) {
    const double pixels = kPi * std::pow(kRadius / kPixel, 2);
    return std::max(0.0, 1 - pixels / kPi * oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
                                 const double d = glm::length(v), r = kPixel / 2;
                                 if (d > kRadius || r >= d) return 0.0;
                                 return 2 * kPi * (1 - std::cos(std::asin(r / d))) *
                                        std::max(glm::dot(v, point.n) / d, 0.0);
                             }));
}

// Open lengths of lines along the axis, z toward the viewer, unit sphere at the origin.
double volumetric(const Field& field, const Point& point, bool hemisphere) {
    double whole = 0;
    const double open = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const dvec3 u = v / kRadius;
        const double front = std::sqrt(std::max(0.0, 1 - u.x * u.x - u.y * u.y));
        const double tangent = -(point.n.x * u.x + point.n.y * u.y) / point.n.z;
        const double low = hemisphere ? std::clamp(tangent, -front, front) : -front;
        whole += hemisphere ? front - low : front;
        return std::max(front - std::max(u.z, low), 0.0);
    });
    return std::min(1.0, open / (whole / (400 * 400 * kPi / 4)));
}

double tangent_sphere(const Field& field, const Point& point) {
    const dvec3 centre = point.p + point.n * kRadius / 2.0;
    double whole = 0;
    const Point at_centre{centre, point.n};
    const double open = oracle::disc_mean(field, at_centre, kRadius / 2, [&](const dvec3& v) {
        const dvec3 u = v / (kRadius / 2);
        const double front = std::sqrt(std::max(0.0, 1 - u.x * u.x - u.y * u.y));
        whole += 2 * front;
        return std::clamp(front - u.z, 0.0, 2 * front);
    });
    return open / (whole / (400 * 400 * kPi / 4));
}

// Mean over directions and steps, both dense, of a march's contributions.
double march(const std::function<double(double azimuth, double shift)>& direction) {
    double sum = 0;
    constexpr int kDirections = 180, kShifts = 4;
    for (int i = 0; i < kDirections; ++i) {
        for (int j = 0; j < kShifts; ++j) sum += direction(2 * kPi * i / kDirections, (j + 0.5) / kShifts);
    }
    return sum / (kDirections * kShifts);
}

// Increments of the horizon, 32 steps.
double hbao(const Field& field, const Point& point, double bias) {
    constexpr int kSteps = 32;
    return 1 - march([&](double azimuth, double shift) {
               const dvec2 d(std::cos(azimuth), std::sin(azimuth));
               const double slope = -glm::dot(dvec2(point.n), d) / point.n.z;
               double horizon = std::min(std::atan(slope) + bias, kPi / 2), occlusion = 0;
               for (int j = 0; j < kSteps; ++j) {
                   const dvec2 at = d * ((j + 1 + shift) * kRadius / (kSteps + 1));
                   const dvec3 v = oracle::surface(field, point.p.x + at.x, point.p.y + at.y) - point.p;
                   const double elevation = std::asin(v.z / glm::length(v)), distance = glm::length(v);
                   if (distance >= kRadius || elevation <= horizon) continue;
                   occlusion +=
                       (1 - std::pow(distance / kRadius, 2)) * (std::sin(elevation) - std::sin(horizon));
                   horizon = elevation;
               }
               return occlusion;
           });
}

// One attenuation, at the last sample in range; t = acos(D·n) - π/2 + bias; steps of `step` metres.
double hbao_hussain(const Field& field, const Point& point, double step, int steps) {
    return march([&](double azimuth, double) {
        const dvec2 d(std::cos(azimuth), std::sin(azimuth));
        const double tangent = std::acos(glm::dot(dvec2(point.n), d)) - kPi / 2 + 0.3;
        double horizon = tangent, last = 0;
        for (int j = 1; j <= steps; ++j) {
            const dvec2 at = d * (step * j);
            const dvec3 v = oracle::surface(field, point.p.x + at.x, point.p.y + at.y) - point.p;
            if (glm::length(v) >= kRadius) continue;
            last = glm::length(v);
            horizon = std::max(horizon, std::atan(v.z / glm::length(dvec2(v))));
        }
        return 1 - std::clamp((1 - std::pow(last / kRadius, 2)) * (std::sin(horizon) - std::sin(tangent)),
                              0.0, 1.0);
    });
}

double hbao_plus(const Field& field, const Point& point) {
    constexpr int kSteps = 32;
    return 1 - march([&](double azimuth, double shift) {
               double sum = 0;
               for (int j = 0; j < kSteps; ++j) {
                   const double t = (j + 1 + shift) * kRadius / (kSteps + 1);
                   const dvec3 v = oracle::surface(field, point.p.x + t * std::cos(azimuth),
                                                   point.p.y + t * std::sin(azimuth)) -
                                   point.p;
                   const double d = glm::length(v);
                   sum += std::max(1 - std::pow(d / kRadius, 2), 0.0) *
                          std::max(glm::dot(v, point.n) / d - 0.1, 0.0);
               }
               return sum / kSteps;
           });
}

double slices(const std::function<double(double azimuth)>& value) {
    constexpr int kSlices = 90;
    double sum = 0;
    for (int i = 0; i < kSlices; ++i) sum += value(kPi * (i + 0.5) / kSlices);
    return sum / kSlices;
}

double gtao(const Field& field, const Point& point) {
    return slices([&](double azimuth) {
        return oracle::slice_visibility(
            oracle::slice(field, point, azimuth, kRadius, [](double d) { return d < kRadius ? 1.0 : 0.0; }));
    });
}

double xegtao(const Field& field, const Point& point) {
    const double radius = kRadius * 1.457;
    const double open = slices([&](double azimuth) {
        auto s = oracle::slice(field, point, azimuth, radius, [&](double d) {
            return std::clamp((radius - d) / (0.615 * radius), 0.0, 1.0);
        });
        const double whole = s.normal_length;
        return oracle::slice_visibility(s) / whole * std::lerp(whole, 1.0, 0.05);
    });
    return std::max(0.03, std::pow(std::min(open, 1.0), 2.2));
}

// Solid surfaces: a slice is open between its horizons.
double uniform_sectors(const Field& field, const Point& point) {
    return slices([&](double azimuth) {
        const auto s =
            oracle::slice(field, point, azimuth, kRadius, [](double d) { return d < kRadius ? 1.0 : 0.0; });
        return (s.h1 - s.h0) / kPi;
    });
}

double ray_march(const Field& field, const Point& point) {
    const glm::dmat3 frame = oracle::basis(point.n);
    return oracle::mean(6000, [&](Random& random) {
        const dvec3 direction = frame * oracle::cosine_direction(random);
        for (int i = 1; i <= 100; ++i) {
            const dvec3 s = point.p + direction * (kRadius * i / 100);
            // The first steps lie within rounding of the surface itself.
            if (field.z(s.x, s.y) > s.z + 1e-6) return 0.0;
        }
        return 1.0;
    });
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
        {"ssao",
         "ssao",
         {{"samples", 256}, {"radius", kRadius}},
         [](const Field& f, const Point& p) {
             return point_test(
                 f, p, [](Random& r) { return in_volume(oracle::hemisphere_direction(r), r); },
                 [&](const dvec3&, double z) { return smooth_step(0, 1, kRadius / std::abs(p.p.z - z)); });
         },
         0.02,
         16},
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
         {{"samples", 256}, {"radius", kRadius}, {"bias", 0.0}},
         [](const Field& f, const Point& p) {
             return point_test(
                 f, p, [](Random& r) { return oracle::cosine_direction(r) * oracle::unit(r); },
                 [&](const dvec3&, double z) { return smooth_step(0, 1, kRadius / std::abs(p.p.z - z)); });
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
             // The very taps: their rotation is a function of the pixel (y runs down).
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
        {"gtao",
         "gtao",
         {{"slices", 32}, {"steps", 60}, {"radius", kRadius}, {"step_power", 1.0}},
         gtao,
         0.02,
         4},
        {"xegtao",
         "xegtao",
         {{"slices", 32}, {"steps", 80}, {"radius", kRadius}, {"step_power", 1.0}, {"mip_offset", 16.0}},
         xegtao,
         0.04,
         4},
        {"bitmask",
         "visibility-bitmask",
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
         {{"directions", 256}, {"steps", 100}, {"radius", kRadius}},
         ray_march,
         0.03,
         1},
    };
    return all;
}

class Estimator : public ::testing::TestWithParam<Case> {};

TEST_P(Estimator, AgreesWithItsPapersFormulaInDoublePrecision) {
    const Case& c = GetParam();
    const auto methods = load_methods();
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = kSize * kPixel / 2;
    const CameraFrame frame(camera, kSize, kSize);
    ScreenRenderer renderer;
    renderer.set_scene(terrain_scene());
    renderer.draw_gbuffer(frame, {"normal_geometric"});
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
                                      static_cast<double>(images.linear_depth.at(pixel.x, pixel.y)));
        point.n = glm::normalize(dvec3(images.normal_geometric.at(pixel.x, pixel.y)));
        const double expected = c.expected(field, point),
                     got = static_cast<double>(mean.at(pixel.x, pixel.y));
        std::printf("%-22s (%d, %d): read %.4f, expected %.4f\n", c.name, pixel.x, pixel.y, got, expected);
        EXPECT_NEAR(got, expected, c.tolerance) << "pixel " << pixel.x << ", " << pixel.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Estimator, ::testing::ValuesIn(cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// A new method must be checked like the others, or be named here with the reason.
TEST(Estimators, OfAllMethodsAreChecked) {
    // Multi-resolution is defined by its passes: its levels are HBAO+'s estimator over a fixed window.
    // The line sweep has no radius: closed_form_test.cpp has it.
    std::set<std::string> checked = {"multi-resolution", "line-sweep"};
    for (const Case& c : cases()) checked.insert(c.method);
    for (const MethodDescriptor& m : load_methods()) EXPECT_TRUE(checked.contains(m.id)) << m.id;
}

}  // namespace
}  // namespace aoscore::testing
