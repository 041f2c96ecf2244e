// The truth at single pixels of a built-in hall against brute force in double precision. These pixels are the
// hardest ones: Cycles, whose samples part at edges, differs there by 0.1 to 0.3.
#include "core/sampling.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/tile_store.h"
#include "reference/integrator/truth_resolve.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace aoscore {
namespace {

constexpr double kRadius_m = 0.5;
constexpr int kWidth = 240, kHeight = 136;
/// Far below what a float32 tracer can tell, far above double precision's rounding.
constexpr double kLift_m = 1e-6;

struct Triangle {
    glm::dvec3 a, ab, ac, low, high;
    glm::dvec3 normal() const { return glm::normalize(glm::cross(ab, ac)); }
};

std::vector<Triangle> triangles_of(const Scene& scene) {
    std::vector<Triangle> all;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto corner = [&](unsigned i) {
            return glm::dvec3(instance.scene_from_mesh * glm::dvec4(glm::dvec3(mesh.positions[i]), 1));
        };
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a = corner(t.x), b = corner(t.y), c = corner(t.z);
            all.push_back({a, b - a, c - a, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
        }
    }
    return all;
}

/// How far along the ray the triangle is met, in lengths of its direction (Tomas Möller, Ben Trumbore, Fast,
/// Minimum Storage Ray/Triangle Intersection, 1997); infinity where it is not, or behind the start.
double met_at(const Triangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const glm::dvec3 p = glm::cross(direction, triangle.ac), s = origin - triangle.a;
    const double scale = 1 / glm::dot(triangle.ab, p), u = glm::dot(s, p) * scale;
    const glm::dvec3 q = glm::cross(s, triangle.ab);
    const double v = glm::dot(direction, q) * scale, t = glm::dot(triangle.ac, q) * scale;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : kNever;
}

/// Visibility at the centre of a pixel by plain rays, with a rank-1 lattice for their directions.
double visibility_at(const std::vector<Triangle>& all, const CameraFrame::Ray& sight) {
    constexpr int kRays = 16384;
    double depth = std::numeric_limits<double>::infinity();
    const Triangle* seen = nullptr;
    for (const Triangle& triangle : all) {
        const double t = met_at(triangle, sight.origin, sight.direction);
        if (t >= depth) continue;
        depth = t;
        seen = &triangle;
    }
    glm::dvec3 normal = seen->normal();
    if (glm::dot(normal, sight.direction) > 0) normal = -normal;
    const glm::dvec3 start = sight.origin + depth * sight.direction + kLift_m * normal;
    std::vector<const Triangle*> near;
    for (const Triangle& triangle : all) {
        if (glm::distance(start, glm::clamp(start, triangle.low, triangle.high)) <= kRadius_m)
            near.push_back(&triangle);
    }
    const glm::dmat3 frame = frame_about(normal);
    int open = 0;
    for (int i = 0; i < kRays; ++i) {
        // The generalised golden ratio of two dimensions (Martin Roberts, 2018).
        const double u = std::fmod(0.5 + i * 0.7548776662466927, 1), v = std::fmod(i * 0.5698402909980532, 1);
        const double phi = 2 * std::numbers::pi * v;
        const glm::dvec3 direction =
            frame * glm::dvec3(std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), std::sqrt(1 - u));
        bool blocked = false;
        for (std::size_t k = 0; k < near.size() && !blocked; ++k)
            blocked = met_at(*near[k], start, direction) <= kRadius_m;
        open += blocked ? 0 : 1;
    }
    return static_cast<double>(open) / kRays;
}

TEST(TheTruthOfAHall, IsThatOfDoublePrecisionWherePixelsLieOnEdges) {
    const Scene scene = load_scene("cathedral");
    const View& view = scene.views.front();
    ASSERT_EQ(view.id, "nave");
    const CameraFrame frame(view.camera, kWidth, kHeight);
    const std::vector<Triangle> all = triangles_of(scene);
    const ReferenceScene reference = ReferenceScene::built_when_needed(scene);
    const std::vector<TruthQuery> queries = {{Falloff::binary, kRadius_m, 0}};
    TruthSettings settings;
    settings.samples = 4096;
    const TileGroups groups(kWidth, kHeight);
    Truth truth = empty_truth(frame, queries, {});
    const std::vector<std::size_t> which{0};
    constexpr std::array<std::array<int, 2>, 12> kPixels{{{221, 12},
                                                          {107, 77},
                                                          {86, 19},
                                                          {61, 89},
                                                          {152, 105},
                                                          {85, 47},
                                                          {81, 111},
                                                          {74, 33},
                                                          {152, 73},
                                                          {131, 84},
                                                          {126, 68},
                                                          {198, 76}}};
    for (const auto& [x, y] : kPixels) {
        for (std::size_t g = 0; g < groups.count(); ++g) {
            for (const Tile& tile : groups.group(g)) {
                if (x < tile.x0 || x >= tile.x1 || y < tile.y0 || y >= tile.y1) continue;
                const std::vector<GroupState> states = reference.trace_groups(frame, queries, settings, {g});
                resolve_group(groups, g, states[0].tiles, frame, {1, which, settings}, truth);
            }
        }
        EXPECT_NEAR(truth.visibility[0].at(x, y), visibility_at(all, frame.ray(x + 0.5, y + 0.5)), 0.005)
            << x << ", " << y;
    }
}

}  // namespace
}  // namespace aoscore
