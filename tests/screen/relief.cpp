#include "relief.h"

#include "hand_made.h"
#include "oracle_formulas.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPixel_m = formula::kPixel;
constexpr double kFloor = Relief::kFloor;

}  // namespace

// Texel 40 is the first of the floor; 79
// lies half a pixel short of the wall's distance, as the taps on the wall lie half a pixel behind its edge.
Relief wall(double ratio, int height) {
    constexpr int kWallPx = 40, kWidth = 128;
    constexpr double kDistance = kWallPx * kPixel_m, kEdge = kWidth / 2 * kPixel_m;
    Relief relief{fmt::format("wall, k = {:g}", ratio),
                  plane_scene({0, 0, kFloor}, {0, 0, 1}, 50),
                  kWidth,
                  height,
                  {},
                  {},
                  true};
    add_quad(relief.scene, {-50, -50, kFloor + ratio * kDistance}, {50 - kEdge + kWallPx * kPixel_m, 0, 0},
             {0, 100, 0});
    for (int y = height / 2 - 4; y < height / 2 + 4; ++y) relief.pixels.emplace_back(2 * kWallPx - 1, y);
    relief.elevation = [ratio](double azimuth) {
        return std::atan(ratio * std::max(std::cos(azimuth), 0.0));
    };
    return relief;
}

Relief pit(double rim_degrees) {
    constexpr int kSize = 121, kSegments = 256;
    constexpr double kRadius = 40 * kPixel_m;
    const double rim = rim_degrees * kPi / 180, top = kFloor + kRadius / std::tan(rim);
    Relief relief{fmt::format("pit, rim at {:g}°", rim_degrees),
                  plane_scene({0, 0, kFloor}, {0, 0, 1}, 50),
                  kSize,
                  kSize,
                  {},
                  {}};
    for (int i = 0; i < kSegments; ++i) {
        const double a = 2 * kPi * i / kSegments, b = 2 * kPi * (i + 1) / kSegments;
        Mesh mesh;
        for (const auto& [angle, r] :
             {std::pair(a, kRadius), std::pair(b, kRadius), std::pair(b, 50.0), std::pair(a, 50.0)}) {
            mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), top);
        }
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        relief.scene.instances.push_back({static_cast<int>(relief.scene.meshes.size()), glm::dmat4(1.0)});
        relief.scene.meshes.push_back(std::move(mesh));
    }
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) relief.pixels.emplace_back(kSize / 2 + x, kSize / 2 + y);
    }
    relief.elevation = [rim](double) { return kPi / 2 - rim; };
    return relief;
}

CameraFrame from_above(int width, int height) {
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = height * kPixel_m / 2;
    return CameraFrame(camera, width, height);
}

}  // namespace aoscore::testing
