// Tests the limits in methods' descriptors in double precision: under the same stress the formula itself is
// as wrong as the shader, so that arithmetic is not at fault.
#include "hand_made.h"
#include "oracle_cases.h"
#include "oracle_formulas.h"
#include "oracle_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace aoscore::testing {
namespace {

using namespace formula;

// A stress of the oracle's height field. The formulas' radius is fixed, so the pixel's size changes instead.
struct OracleStress {
    const char* axis;
    double footprint_m = kPixel;
    Precision precision = Precision::full;
    std::function<double(double, double)> z;       ///< the true surface
    std::function<double(double, double)> stored;  ///< the surface in a depth buffer, at any place
};

// The centre of the texel that covers x.
double texel_centre(double x, double footprint_m) {
    const double half = formula::kSize / 2.0;
    return (std::floor(x / footprint_m + half) + 0.5 - half) * footprint_m;
}

// The radius is less than half a pixel, on a slope of which each texel holds one depth.
OracleStress radius_below_a_pixel() {
    const auto slope = [](double x, double y) { return -80 + 1.6 * x + 0.6 * y; };
    OracleStress stress{"radius", 1.0, Precision::full, slope, {}};
    stress.stored = [=](double x, double y) { return slope(texel_centre(x, 1), texel_centre(y, 1)); };
    return stress;
}

// The radius is 800 pixels: the picture is flat, with walls all around beyond it, where a depth buffer has
// nothing.
OracleStress radius_beyond_the_picture() {
    constexpr double kFootprint = kRadius / 800, kHalf = formula::kSize * kFootprint / 2;
    const auto arena = [](double x, double y) {
        return -6 + std::max(0.0, 3 * (std::hypot(x, y) - 1.5 * kHalf));
    };
    OracleStress stress{"radius", kFootprint, Precision::full, arena, {}};
    stress.stored = [=](double x, double y) {
        return std::max(std::abs(x), std::abs(y)) < kHalf ? arena(x, y) : -front_camera().far;
    };
    return stress;
}

// Depth has 16 bits between near and far plane.
OracleStress coarse_depth() {
    const auto slope = [](double x, double y) { return -6 + 0.25 * x + 0.1 * y; };
    OracleStress stress{"depth-format", kPixel, Precision::linear_16, slope, {}};
    stress.stored = [=](double x, double y) {
        const double near = front_camera().near, span = front_camera().far - near;
        const double d = -slope(texel_centre(x, kPixel), texel_centre(y, kPixel));
        return -(near + std::round((d - near) / span * 65535) / 65535 * span);
    };
    return stress;
}

struct LimitCase {
    const char* name;  ///< name of an oracle case
    OracleStress (*stress)();
    const char* id;
};

void PrintTo(const LimitCase& limit, std::ostream* out) {
    *out << limit.id << " " << limit.name;
}

const std::vector<LimitCase>& limit_cases() {
    static const std::vector<LimitCase> all = [] {
        std::vector<LimitCase> cases;
        for (const char* name : {"starcraft", "ssao", "hemisphere", "monte_carlo", "tangent_sphere"})
            cases.push_back({name, radius_below_a_pixel, "below_a_pixel"});
        for (const char* name :
             {"starcraft", "ssao", "hemisphere", "monte_carlo", "n8ao", "sao", "cacao", "volumetric_sphere",
              "volumetric_hemisphere", "tangent_sphere", "hbao", "hbao_plus", "gtao", "xegtao", "bitmask",
              "ray_march", "alchemy", "alchemy_spiral"})
            cases.push_back({name, radius_beyond_the_picture, "beyond_the_picture"});
        return cases;
    }();
    return all;
}

const formula::Case& oracle_case(const std::string& name) {
    const auto& all = formula::cases();
    return *std::find_if(all.begin(), all.end(), [&](const formula::Case& c) { return c.name == name; });
}

class Limit : public ::testing::TestWithParam<LimitCase> {};

TEST_P(Limit, IsThePapersFormulaItself) {
    const OracleStress stress = GetParam().stress();
    const formula::Case& c = oracle_case(GetParam().name);
    const auto methods = load_methods();
    const CameraFrame frame = oracle_frame(stress.footprint_m);
    ScreenRenderer renderer;
    renderer.set_scene(height_field_scene(stress.z, stress.footprint_m));
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const GBufferImages images = renderer.read_gbuffer();
    const ImageF shader = mean_over_seeds(renderer, methods, c, stress.precision);
    const Field stored{stress.stored, stress.footprint_m}, there{stress.z, stress.footprint_m};
    double apart = 0;
    const std::vector<glm::ivec2> pixels = {{60, 60}, {58, 61}, {63, 57}};
    for (const glm::ivec2& pixel : pixels) {
        const Point point = point_at(frame, images, pixel.x, pixel.y);
        const Point held{{point.p.x, point.p.y, stress.stored(point.p.x, point.p.y)}, point.n};
        const double expected = c.expected(stored, held), unlimited = c.expected(there, point);
        const auto got = static_cast<double>(shader.at(pixel.x, pixel.y));
        std::printf("%-22s (%d, %d): read %.4f, formula %.4f, of what is there %.4f\n", c.name, pixel.x,
                    pixel.y, got, expected, unlimited);
        EXPECT_NEAR(got, expected, c.tolerance) << "pixel " << pixel.x << ", " << pixel.y;
        apart += std::abs(expected - unlimited) / static_cast<double>(pixels.size());
    }
    EXPECT_GT(apart, 0.03) << "the formula has no limit here";
    EXPECT_TRUE(find_method(methods, c.method).limits.contains(stress.axis))
        << c.method << " does not say so in its descriptor";
}

INSTANTIATE_TEST_SUITE_P(Methods, Limit, ::testing::ValuesIn(limit_cases()), [](const auto& tested) {
    return std::string(tested.param.id) + "_" + tested.param.name;
});

// The finest level of the multi-resolution method at a pixel, whose result can only be darker.
double finest_level(const Field& field, const Point& point) {
    constexpr int kWindow = 2;
    constexpr double kReach = 0.5, kStrength = 2;
    double sum = 0, taps = 0;
    for (int y = -kWindow; y <= kWindow; ++y) {
        for (int x = -kWindow; x <= kWindow; ++x) {
            if (((x + y) & 1) != 0 || (x == 0 && y == 0)) continue;
            const glm::dvec3 v =
                oracle::surface(field, point.p.x + x * field.footprint, point.p.y + y * field.footprint) -
                point.p;
            sum += std::max(1 - glm::dot(v, v) / (kReach * kReach), 0.0) *
                   std::max(glm::dot(v, point.n) / glm::length(v), 0.0);
            ++taps;
        }
    }
    return 1 - kStrength * sum / taps;
}

// Sphere caps' formula: a sphere half a pixel wide at every texel within the radius.
double caps_of_all_texels(const Field& field, const Point& point) {
    const int reach = static_cast<int>(kRadius / field.footprint) + 1;
    double sum = 0;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            if (x == 0 && y == 0) continue;
            const glm::dvec3 v =
                oracle::surface(field, point.p.x + x * field.footprint, point.p.y + y * field.footprint) -
                point.p;
            const double distance = glm::length(v), sphere = field.footprint / 2;
            if (distance > kRadius || std::hypot(v.x, v.y) > kRadius) continue;
            const double ratio = sphere / distance;
            sum += 2 * (1 - std::sqrt(1 - ratio * ratio)) * std::max(glm::dot(v, point.n) / distance, 0.0);
        }
    }
    return std::clamp(1 - sum, 0.0, 1.0);
}

class LimitOfCoarseDepth : public ::testing::Test {
  protected:
    LimitOfCoarseDepth() {
        renderer_.set_scene(height_field_scene(stress_.z, stress_.footprint_m));
        renderer_.draw_gbuffer(frame_, gbuffer_inputs());
        images_ = renderer_.read_gbuffer();
    }

    /// Means over a block of pixels: of the formula on the stored depth and on the true surface, and of the
    /// shader on the stored depth.
    struct Means {
        double formula = 0, unlimited = 0, shader = 0;
    };
    Means means(const ImageF& shader, double (*formula)(const Field&, const Point&)) const {
        const Field stored{stress_.stored, stress_.footprint_m}, there{stress_.z, stress_.footprint_m};
        constexpr int kFrom = 50, kSide = 20;
        Means sum;
        for (int y = kFrom; y < kFrom + kSide; ++y) {
            for (int x = kFrom; x < kFrom + kSide; ++x) {
                const Point point = point_at(frame_, images_, x, y);
                const Point held{{point.p.x, point.p.y, stress_.stored(point.p.x, point.p.y)}, point.n};
                sum.formula += formula(stored, held) / (kSide * kSide);
                sum.unlimited += formula(there, point) / (kSide * kSide);
                sum.shader += static_cast<double>(shader.at(x, y)) / (kSide * kSide);
            }
        }
        std::printf("read %.4f, formula %.4f, of what is there %.4f\n", sum.shader, sum.formula,
                    sum.unlimited);
        return sum;
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    OracleStress stress_ = coarse_depth();
    CameraFrame frame_ = oracle_frame(stress_.footprint_m);
    ScreenRenderer renderer_;
    GBufferImages images_;
};

TEST_F(LimitOfCoarseDepth, IsTheFormulaOfSphereCaps) {
    const Means m = means(mean_over_seeds(renderer_, methods_, oracle_case("sphere_caps"), stress_.precision),
                          caps_of_all_texels);
    EXPECT_NEAR(m.shader, m.formula, 0.02);
    EXPECT_GT(m.unlimited - m.formula, 0.01);
    EXPECT_TRUE(find_method(methods_, "sphere-caps").limits.contains("depth-format"));
}

TEST_F(LimitOfCoarseDepth, IsThatTapsOfMultiResolutionAreAPixelAway) {
    MethodRequest request;
    request.method = &find_method(methods_, "multi-resolution");
    request.parameters = request.method->values("default");
    request.precision = stress_.precision;
    const Means m = means(renderer_.run(request).raw, finest_level);
    EXPECT_LE(m.shader, m.formula + 0.01) << "the finest level bounds it from above";
    EXPECT_GT(m.unlimited - m.formula, 0.01);
    EXPECT_TRUE(request.method->limits.contains("depth-format"));
}

// The methods' bias is a height over the tangent plane that grows with the distance from the eye.
TEST(LimitOfAlchemy, IsThatItsBiasGrowsWithTheDistance) {
    const auto bowl_at = [](double distance) {
        return [=](double x, double y) { return -distance + 2 * (x * x + y * y); };
    };
    const auto methods = load_methods();
    const CameraFrame frame = oracle_frame(kPixel);
    ScreenRenderer renderer;
    for (const char* name : {"alchemy", "alchemy_spiral"}) {
        const formula::Case& c = oracle_case(name);
        double formulas[2] = {};
        for (int i = 0; i < 2; ++i) {
            const auto bowl = bowl_at(i == 0 ? 6 : 90);
            renderer.set_scene(height_field_scene(bowl, kPixel));
            renderer.draw_gbuffer(frame, gbuffer_inputs());
            const ImageF shader = mean_over_seeds(renderer, methods, c);
            const Point point = point_at(frame, renderer.read_gbuffer(), 60, 60);
            formulas[i] = c.expected(Field{bowl, kPixel}, point);
            EXPECT_NEAR(static_cast<double>(shader.at(60, 60)), formulas[i], c.tolerance) << name;
        }
        EXPECT_GT(formulas[1] - formulas[0], 0.03) << name;
        EXPECT_TRUE(find_method(methods, c.method).limits.contains("fov")) << name;
    }
}

// Its steps are a share of the picture, not of the radius.
TEST(LimitOfHbaoHussain, IsThatItLooksOnlyAsFarAsItsSteps) {
    const OracleStress stress = radius_beyond_the_picture();
    const auto methods = load_methods();
    const CameraFrame frame = oracle_frame(stress.footprint_m);
    ScreenRenderer renderer;
    renderer.set_scene(height_field_scene(stress.z, stress.footprint_m));
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const ImageF shader = mean_over_seeds(renderer, methods, oracle_case("hbao_hussain"));
    const Point point = point_at(frame, renderer.read_gbuffer(), 60, 60);
    const Field there{stress.z, stress.footprint_m};
    const double formula = hbao_hussain(there, point, 2.5 * stress.footprint_m, 20);
    EXPECT_NEAR(static_cast<double>(shader.at(60, 60)), formula, 0.02);
    EXPECT_GT(formula - gtao(there, point), 0.1);
    EXPECT_TRUE(find_method(methods, "hbao-hussain").limits.contains("radius"));
}

// A plane that faces a camera of 170 degrees, in double precision. Open as it is, its part in the slice
// through the view vector and a direction of the picture is the whole arc about the projected normal (Jimenez
// et al., Practical Real-Time Strategies for Accurate Indirect Occlusion, 2016), of which a mean that is even
// about the view vector is 1.
class LimitOfWideAngles : public ::testing::Test {
  protected:
    static constexpr int kSide = 1001;     ///< lines of a sweep pass half a pixel beside its pixels
    static constexpr double kTan = 11.43;  ///< of half the angle of view, 170 degrees

    LimitOfWideAngles() {
        Camera camera = front_camera();
        camera.fovy_rad = 2 * std::atan(kTan);
        renderer_.set_scene(plane_scene({0, 0, -4}, {0, 0, 1}, 300));
        renderer_.draw_gbuffer(CameraFrame(camera, kSide, kSide), gbuffer_inputs());
    }

    static glm::dvec3 view_vector(int x) {
        return glm::normalize(glm::dvec3(-kTan * ((x + 0.5) / kSide * 2 - 1), 0, 1));
    }
    struct Slice {
        double open = 0;   ///< the plane's part of the slice
        double spans = 0;  ///< the angle about the view vector for each angle of the picture
    };
    static Slice slice(const glm::dvec3& view, double azimuth) {
        const glm::dvec3 direction(std::cos(azimuth), std::sin(azimuth), 0), normal(0, 0, 1);
        const glm::dvec3 axis = glm::normalize(glm::cross(direction, view));
        const glm::dvec3 projected = normal - axis * glm::dot(axis, normal);
        const double length = glm::length(projected);
        const double gamma = std::acos(std::clamp(glm::dot(projected, view) / length, -1.0, 1.0));
        const glm::dvec3 along = direction - view * glm::dot(direction, view);
        return {length * (std::cos(gamma) + gamma * std::sin(gamma)), view.z / glm::dot(along, along)};
    }
    static double mean(const glm::dvec3& view, int slices, bool spanned) {
        double sum = 0;
        for (int i = 0; i < slices; ++i) {
            const Slice one = slice(view, (i + 0.5) * std::numbers::pi / slices);
            sum += (spanned ? one.spans : 1) * one.open / slices;
        }
        return std::min(sum, 1.0);
    }

    // Tests pixels along the middle row, out to 80 degrees from the axis.
    void expect_formula(const std::string& method, const ParameterValues& parameters, int slices,
                        bool spanned) {
        const std::vector<MethodDescriptor> methods = load_methods();
        MethodRequest request;
        request.method = &find_method(methods, method);
        request.parameters = request.method->values("default", parameters);
        const ImageF shader = renderer_.run(request).raw;
        double farthest = 0;
        for (const int x : {500, 562, 625, 687, 733}) {
            const glm::dvec3 view = view_vector(x);
            const double formula = mean(view, slices, spanned);
            std::printf("%s, %.1f degrees off: read %.4f, formula %.4f\n", method.c_str(),
                        std::acos(view.z) * 180 / std::numbers::pi,
                        static_cast<double>(shader.at(x, kSide / 2)), formula);
            EXPECT_NEAR(static_cast<double>(shader.at(x, kSide / 2)), formula, 0.02) << "column " << x;
            farthest = std::max(farthest, 1 - formula);
        }
        EXPECT_GT(farthest, 0.05) << "the formula has no limit here";
        EXPECT_TRUE(request.method->limits.contains("fov")) << method;
    }

    ScreenRenderer renderer_;
};

TEST_F(LimitOfWideAngles, IsThatSlicesOfXeGtaoAreEvenInThePicture) {
    expect_formula("xegtao", {{"slices", 64}, {"final_power", 1.0}, {"normal_lerp", 0.0}, {"acos", "exact"}},
                   4096, false);
}

TEST_F(LimitOfWideAngles, IsThatLineSweepHasSixteenDirectionsOfThePicture) {
    expect_formula("line-sweep", {{"directions", 16}}, 8, true);
}

}  // namespace
}  // namespace aoscore::testing
