// Tests cameras beside the view's own, of which methods read depth layers too.
#include "core/error.h"
#include "hand_made.h"
#include "screen/method/lengths.h"
#include "support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr const char* kMethod = "sd-hbao-plus";
constexpr int kWidth = 200, kHeight = 120;
const ParameterValues kPlain = {{"depth_samples", 1}, {"alpha", 1.0}, {"side_alpha", 1.0}, {"noise", "none"}};

class SideCameras : public ::testing::Test {
  protected:
    void look_at(const Scene& scene, const CameraFrame& frame) {
        renderer_.set_scene(scene);
        renderer_.draw_gbuffer(frame, gbuffer_inputs());
    }
    const MethodDescriptor& method() const { return find_method(methods_, kMethod); }
    ImageF run(const ParameterValues& parameters) {
        MethodRequest request;
        request.method = &method();
        request.parameters = parameters;
        return renderer_.run(request).raw;
    }
    ImageF run_with(ParameterValues changes, const ParameterValues& further = {}) {
        for (const auto& [id, value] : further) changes[id] = value;
        return run(method().values("default", changes));
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    ScreenRenderer renderer_;
};

/// A wall, and a plate at right angles to it that the camera at the origin sees edge-on: it covers no pixel.
constexpr double kWall = 6, kPlateFront = 5.2, kPlateHalf = 1.5;

Scene edge_on_plate() {
    Scene scene = empty_scene();
    add_quad(scene, {-20, -20, -kWall}, {40, 0, 0}, {0, 40, 0});
    add_quad(scene, {0, -kPlateHalf, -kWall}, {0, 0, kWall - kPlateFront}, {0, 2 * kPlateHalf, 0});
    return scene;
}

/// A camera on that scene by rays, in double.
class PlateCamera {
  public:
    PlateCamera(const Camera& camera, const glm::dvec3& place, const glm::dvec3& target)
        : focal_px_(0.5 * kHeight / std::tan(camera.fovy_rad / 2)),
          from_world_(glm::lookAt(place, target, {0, 1, 0})),
          place_(place) {}

    double depth_of(const glm::dvec3& point) const { return -(from_world_ * glm::dvec4(point, 1)).z; }
    double pixels_per_metre(const glm::dvec3& point) const { return focal_px_ / depth_of(point); }
    glm::dvec2 image_of(const glm::dvec3& point) const {
        const glm::dvec3 seen(from_world_ * glm::dvec4(point, 1));
        return {0.5 * kWidth - seen.x / seen.z * focal_px_, 0.5 * kHeight + seen.y / seen.z * focal_px_};
    }
    /// The surface behind the centre of the texel.
    glm::dvec3 seen_at(const glm::dvec2& image_px) const {
        const glm::dvec2 centre_px = glm::floor(image_px) + 0.5;
        const glm::dvec3 in_view((centre_px.x - 0.5 * kWidth) / focal_px_,
                                 (0.5 * kHeight - centre_px.y) / focal_px_, -1);
        return hit(glm::transpose(glm::dmat3(from_world_)) * in_view);
    }
    const glm::dvec3& place() const { return place_; }

  private:
    glm::dvec3 hit(const glm::dvec3& direction) const {
        const glm::dvec3 on_wall = place_ + direction * ((-kWall - place_.z) / direction.z);
        const double to_plate = -place_.x / direction.x;
        const glm::dvec3 on_plate = place_ + direction * to_plate;
        const bool hits = to_plate > 0 && on_plate.z > -kWall && on_plate.z < -kPlateFront &&
                          std::abs(on_plate.y) < kPlateHalf;
        return hits ? on_plate : on_wall;
    }

    double focal_px_;
    glm::dmat4 from_world_;
    glm::dvec3 place_;
};

bool in_picture(const glm::dvec2& px) {
    return px.x >= 0 && px.y >= 0 && px.x < kWidth && px.y < kHeight;
}

/// The direction of the i-th of four without noise.
glm::dvec2 direction(int i) {
    const double angle = (i + 0.75) * std::numbers::pi / 2;
    return {std::cos(angle), std::sin(angle)};
}

/// The mean over 4 directions of 4 steps by algorithm 12 of Vermeer 2020, of a point of the wall.
double hbao_plus_occlusion(const PlateCamera& camera, const glm::dvec3& point, double radius, double bias) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double step_px = radius * camera.pixels_per_metre(point) / 5 * (j + 1.5);
            const glm::dvec2 tap_px = camera.image_of(point) + step_px * direction(i);
            if (!in_picture(tap_px)) continue;
            const glm::dvec3 v = camera.seen_at(tap_px) - point;
            const double distance = glm::length(v);
            sum += std::max(1 - distance * distance / (radius * radius), 0.0) *
                   std::max(v.z / distance - bias, 0.0);
        }
    }
    return sum / 16;
}

/// The occlusion of a lifted point of the wall and the confidence of one camera, by the program of HBAO of
/// Vardis, Papaioannou and Gaitatzes 2013: 4 slices of 4 samples.
std::pair<double, double> sure_occlusion(const PlateCamera& camera, const glm::dvec3& point, double radius) {
    double occlusion = 0, distances = 0;
    for (int i = 0; i < 4; ++i) {
        glm::dvec3 along(-direction(i).y, direction(i).x, 0);  // the frame begins at the vertical
        double highest = 0;
        for (int j = 1; j <= 4; ++j) {
            const glm::dvec3 sample = point + along * ((j - 0.5) * radius / 4);
            const glm::dvec2 inner =
                glm::clamp(camera.image_of(sample), glm::dvec2(0.5), glm::dvec2(kWidth - 0.5, kHeight - 0.5));
            const glm::dvec3 surface = camera.seen_at(inner);
            const double distance = glm::distance(surface, point), height = (surface.z - point.z) / distance;
            const bool seen = camera.depth_of(sample) < camera.depth_of(surface);
            distances += seen ? std::min(distance, radius) : radius;
            if (height > highest && distance <= radius) {
                highest = height;
                along = (surface - point) / distance;
            }
        }
        occlusion += highest / 4;
    }
    const glm::dvec3 toward = glm::normalize(camera.place() - point);
    return {occlusion, 0.9 * (1 - distances / (16 * radius)) + 0.1 * std::max(toward.z, 0.0) + 0.001};
}

/// The share of the picture's pixels that differ by more than 2e-3 from what `expected` says of a point of
/// the wall: those of which rounding pushes a tap over the edge of a texel. Counts those that are dark, too.
double share_off(const ImageF& image, const CameraFrame& frame,
                 const std::function<double(const glm::dvec3&)>& expected, std::size_t& dark) {
    std::size_t off = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double visibility = expected(frame.view_position(x + 0.5, y + 0.5, kWall));
            off += std::abs(static_cast<double>(image.at(x, y)) - visibility) > 2e-3 ? 1 : 0;
            dark += visibility < 0.97 ? 1 : 0;
        }
    }
    return static_cast<double>(off) / static_cast<double>(image.size());
}

TEST_F(SideCameras, FindAnOccluderThatTheViewsOwnCameraSeesEdgeOn) {
    const Camera camera = front_camera();
    const CameraFrame frame(camera, kWidth, kHeight);
    look_at(edge_on_plate(), frame);
    const double radius = 0.8, bias = 0.1, right = 1.5, ahead = 0.5, aim = 7;
    const ParameterValues alone = {
        {"radius", radius}, {"side_right", right}, {"side_ahead", ahead}, {"side_aim", aim}};
    for (const float v : run_with(kPlain, alone).pixels) ASSERT_GE(v, 1 - 1e-6F) << "the plate is seen";

    ParameterValues both = alone;
    both["side_cameras"] = 1;
    const PlateCamera second(camera, {right, 0, -ahead}, {0, 0, -aim});
    std::size_t dark = 0;
    const double off = share_off(
        run_with(kPlain, both), frame,
        [&](const glm::dvec3& point) { return 1 - hbao_plus_occlusion(second, point, radius, bias); }, dark);
    EXPECT_GT(dark, kWidth * kHeight / 50);
    EXPECT_LE(off, 0.005);
}

TEST_F(SideCameras, AreWeightedByTheirConfidence) {
    const Camera camera = front_camera();
    const CameraFrame frame(camera, kWidth, kHeight);
    look_at(edge_on_plate(), frame);
    const double radius = 0.8, lift = 0.05, right = 1.5, ahead = 0.5, aim = 7;
    MethodRequest request;
    request.method = &find_method(methods_, "multi-view-hbao");
    request.parameters = request.method->values("default", {{"noise", "none"},
                                                            {"radius", radius},
                                                            {"lift", lift},
                                                            {"side_right", right},
                                                            {"side_ahead", ahead},
                                                            {"side_aim", aim}});
    const std::vector<PlateCamera> cameras = {{camera, {0, 0, 0}, {0, 0, -1}},
                                              {camera, {right, 0, -ahead}, {0, 0, -aim}},
                                              {camera, {-right, 0, -ahead}, {0, 0, -aim}}};
    std::size_t dark = 0;
    const double off = share_off(
        renderer_.run(request).raw, frame,
        [&](const glm::dvec3& point) {
            double occlusion = 0, sum = 0;
            for (const PlateCamera& one : cameras) {
                const auto [found, confidence] = sure_occlusion(one, point + glm::dvec3(0, 0, lift), radius);
                occlusion += confidence * found;
                sum += confidence;
            }
            return 1 - occlusion / sum;
        },
        dark);
    EXPECT_GT(dark, kWidth * kHeight / 50);
    EXPECT_LE(off, 0.01);
}

// The point is brought into the second picture and back, so that rounding pushes some taps over the edge of
// their texel; everything else is the same to the bit.
TEST_F(SideCameras, ThatStandWhereTheViewsOwnDoesChangeNothing) {
    const Scene atrium = load_scene("atrium");
    Camera parallel = corner_camera();
    parallel.projection = Camera::Projection::orthographic;
    parallel.half_height = 1.7;
    const std::vector<std::pair<Scene, CameraFrame>> views = {
        {atrium, CameraFrame(find_view(atrium, "wide").camera, 160, 90)},
        {corner_scene(), CameraFrame(corner_camera(), 160, 90)},
        {corner_scene(), CameraFrame(parallel, 97, 61)}};
    for (const auto& [scene, frame] : views) {
        look_at(scene, frame);
        for (const int samples : {1, 4, 8}) {
            ParameterValues settings = {
                {"depth_samples", samples}, {"side_alpha", 0.2}, {"side_right", 0.0}, {"side_ahead", 0.0}};
            const ImageF one = run_with(settings);
            settings["side_cameras"] = 1;
            const ImageF two = run_with(settings);
            std::size_t other = 0;
            for (std::size_t i = 0; i < one.size(); ++i) {
                ASSERT_LE(two.pixels[i], one.pixels[i]) << "a maximum has fallen";
                other += two.pixels[i] != one.pixels[i] ? 1 : 0;
            }
            EXPECT_LE(other, one.size() / 50) << samples;
        }
    }
}

TEST_F(SideCameras, FindTheSameInAnyUnit) {
    const double unit = 1000;
    Camera camera = front_camera();
    look_at(edge_on_plate(), CameraFrame(camera, kWidth, kHeight));
    const ImageF metres = run(values_for_radius(method(), 0.8, "two-cameras"));
    Scene large = edge_on_plate();
    for (Mesh& mesh : large.meshes) {
        for (glm::vec3& p : mesh.positions) p *= static_cast<float>(unit);
    }
    for (double* length : {&camera.near, &camera.far}) *length *= unit;
    look_at(large, CameraFrame(camera, kWidth, kHeight));
    const ImageF millimetres = run(values_for_radius(method(), 0.8 * unit, "two-cameras"));
    std::size_t other = 0;
    for (std::size_t i = 0; i < metres.size(); ++i)
        other += std::abs(metres.pixels[i] - millimetres.pixels[i]) > 1e-3F ? 1 : 0;
    EXPECT_LE(other, metres.size() / 100);
    EXPECT_LT(mean_over(metres, Mask(kWidth, kHeight, 1)), 0.9995) << "nothing was found";
}

TEST_F(SideCameras, OfHalfTheResolutionFindNearlyTheSame) {
    look_at(edge_on_plate(), CameraFrame(front_camera(), kWidth + 1, kHeight + 1));
    ParameterValues settings = {{"radius", 0.8}, {"side_cameras", 1}};
    const Mask all(kWidth + 1, kHeight + 1, 1);
    const double full = mean_over(run_with(kPlain, settings), all);
    settings["side_scale"] = 2;
    const double half = mean_over(run_with(kPlain, settings), all);
    EXPECT_LT(full, 0.999);
    EXPECT_NEAR(half, full, 0.1 * (1 - full));
}

// What a camera to the right finds, another of the four finds from the left, from above and from below.
TEST_F(SideCameras, StandAroundTheLineOfSight) {
    look_at(edge_on_plate(), CameraFrame(front_camera(), kWidth, kHeight));
    const auto sides = [&](int cameras) {
        const ImageF image = run_with(kPlain, {{"radius", 0.8}, {"side_cameras", cameras}});
        Mask left(kWidth, kHeight, 0), right = left;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) (x < kWidth / 2 ? left : right).at(x, y) = 1;
        }
        return std::pair(1 - mean_over(image, left), 1 - mean_over(image, right));
    };
    const auto [left_of_one, right_of_one] = sides(1);
    const auto [left_of_two, right_of_two] = sides(2);
    EXPECT_GT(right_of_one, 1.2 * left_of_one);
    EXPECT_NEAR(left_of_two, right_of_two, 0.02 * right_of_two);
    EXPECT_GE(right_of_two, right_of_one);
}

TEST_F(SideCameras, ThatLookAtAPointBehindThemAreRefused) {
    look_at(edge_on_plate(), CameraFrame(front_camera(), 32, 32));
    try {
        run_with(kPlain, {{"side_cameras", 1}, {"side_ahead", 3.0}, {"side_aim", 2.0}});
        FAIL() << "a camera that looks back was accepted";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), ::testing::HasSubstr("not in front of them"));
    }
}

// Depth layers are drawn for the cameras that a setting reads, and once.
TEST_F(SideCameras, AreDrawnOnlyWhereASettingReadsThem) {
    look_at(edge_on_plate(), CameraFrame(front_camera(), 64, 64));
    const auto drawn = [&](const ParameterValues& settings) {
        const std::uint64_t before = renderer_.work().layered_pictures;
        run_with(kPlain, settings);
        return renderer_.work().layered_pictures - before;
    };
    EXPECT_EQ(drawn({}), 1U);
    EXPECT_EQ(drawn({}), 0U);
    EXPECT_EQ(drawn({{"side_cameras", 1}}), 1U);
    EXPECT_EQ(drawn({{"side_cameras", 3}}), 3U);
    EXPECT_EQ(drawn({{"side_cameras", 0}, {"side_right", 3.0}}), 0U);
}

}  // namespace
}  // namespace aoscore::testing
