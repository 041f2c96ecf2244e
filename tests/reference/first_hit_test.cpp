// The surface that a ray meets first, where two surfaces meet: along edges, and where boxes stand in a floor.
// Float32 cannot tell there which lies in front.
#include "core/sampling.h"
#include "reference/test_scenes.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace aoscore {
namespace {

/// Random numbers in [-1, 1].
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 1'000'000) {}
    double operator()() { return static_cast<double>(mix_bits(state_++) >> 11) * 0x1p-53 * 2 - 1; }
    double sign() { return (*this)() < 0 ? -1 : 1; }

  private:
    std::uint64_t state_;
};

/// The unit cube about the origin.
Mesh cube() {
    Mesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                                    (corner & 4) != 0 ? 0.5 : -0.5);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Boxes that are sunk half into a floor, all of it turned together in space, and boxes far away from it.
struct Town {
    static constexpr int kBoxes = 60, kFarBoxes = 200;
    Scene scene = testing::empty_scene();
    std::vector<char> near_ones;  ///< one flag an instance: it is not one of those far away
    glm::dmat4 turn;

    explicit Town(std::uint64_t seed) {
        Random random(seed);
        turn = glm::rotate(glm::dmat4(1), 3 * random(), glm::normalize(glm::dvec3(random(), random(), 1.5)));
        scene.meshes = {testing::quad({-10, 0, 10}, {10, 0, 10}, {10, 0, -10}, {-10, 0, -10}), cube()};
        scene.instances.push_back({0, turn});
        for (int i = 0; i < kBoxes; ++i) {
            glm::dmat4 m = glm::translate(turn, {4 * random(), 0.0, 4 * random()});
            m = glm::rotate(m, 3 * random(), {0, 1, 0});
            scene.instances.push_back({1, glm::scale(m, {1.5 + random(), 1.5 + random(), 1.5 + random()})});
        }
        near_ones.assign(scene.instances.size(), 1);
        for (int i = 0; i < kFarBoxes; ++i)
            scene.instances.push_back(
                {1, glm::translate(turn, {40 * random(), 30 + 5 * random(), 40 * random()})});
        near_ones.resize(scene.instances.size(), 0);
    }

    /// A place in a cube where its side passes through the floor, and one on its upright edge.
    static glm::dvec3 on_the_floor(Random& random) { return {random.sign() / 2, 0.0, random() / 2}; }
    static glm::dvec3 on_an_edge(Random& random) {
        return {random.sign() / 2, 0.25 + random() / 4, random.sign() / 2};
    }
    /// A ray from above to such a place in one of the boxes.
    CameraFrame::Ray ray_to(glm::dvec3 (*place)(Random&), Random& random) const {
        const auto box = static_cast<std::size_t>(1 + (random() + 1) / 2 * (kBoxes - 1));
        const glm::dvec3 to(scene.instances[box].scene_from_mesh * glm::dvec4(place(random), 1));
        const glm::dvec3 from(turn * glm::dvec4(8 * random(), 3 + random(), 8 * random(), 1));
        return {from, glm::normalize(to - from)};
    }
};

/// A triangle that a ray meets, by double precision.
struct Met {
    double depth = std::numeric_limits<double>::infinity();
    glm::dvec3 normal{0};
};

/// The nearest that a ray meets of all triangles, and the nearest of those that lie in another plane
/// (Tomas Möller, Ben Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997). The corners are those
/// that a tracer is given, float32 about `centre`.
std::array<Met, 2> nearest_two(const Scene& scene, const glm::dvec3& centre, const CameraFrame::Ray& ray) {
    std::vector<Met> all;
    const glm::dvec3 origin = ray.origin - centre;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const glm::dmat4 place = glm::translate(glm::dmat4(1), -centre) * instance.scene_from_mesh;
        const auto corner = [&](unsigned i) {
            return glm::dvec3(glm::vec3(place * glm::dvec4(glm::dvec3(mesh.positions[i]), 1)));
        };
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a = corner(t.x), ab = corner(t.y) - a, ac = corner(t.z) - a;
            const glm::dvec3 p = glm::cross(ray.direction, ac), s = origin - a, q = glm::cross(s, ab);
            const double scale = 1 / glm::dot(ab, p);
            const double u = glm::dot(s, p) * scale, v = glm::dot(ray.direction, q) * scale;
            const double depth = glm::dot(ac, q) * scale;
            if (u >= 0 && v >= 0 && u + v <= 1 && depth > 0)
                all.push_back({depth, glm::normalize(glm::cross(ab, ac))});
        }
    }
    std::array<Met, 2> two;
    for (const Met& met : all) {
        if (met.depth < two[0].depth) two[0] = met;
    }
    for (const Met& met : all) {
        if (met.depth < two[1].depth && std::abs(glm::dot(met.normal, two[0].normal)) < 0.999) two[1] = met;
    }
    return two;
}

constexpr double kFar = 100;

// Edges are left out: which side of them a ray passes is decided in float32.
TEST(FirstHit, IsTheNearestByDoublePrecisionWhereOneSurfacePassesThroughAnother) {
    constexpr double kToldApart = 1e-12, kTie = 1e-6;
    int checked = 0, wrong = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Town town(seed);
        const auto tracer = new_ray_tracer(town.scene, {});
        Random random(seed + 100);
        for (int i = 0; i < 3000; ++i) {
            const CameraFrame::Ray ray = town.ray_to(Town::on_the_floor, random);
            const auto [first, second] = nearest_two(town.scene, tracer->centre(), ray);
            const double gap = second.depth - first.depth;
            if (!(gap > kToldApart * first.depth && gap < kTie * first.depth)) continue;
            ++checked;
            SurfaceHit hit;
            ASSERT_TRUE(tracer->first_hit(ray, 0, kFar, hit));
            wrong += std::abs(glm::dot(hit.normal, first.normal)) < 0.999 ||
                     std::abs(hit.depth - first.depth) > 1e-12 * first.depth;
        }
    }
    EXPECT_GT(checked, 300) << "rays that meet two surfaces almost at once";
    EXPECT_EQ(wrong, 0) << "of " << checked;
}

TEST(FirstHit, IsTheSameBitsWhereverTheSceneIsDividedIntoTrees) {
    for (const std::size_t baked : {std::size_t{2'000'000}, std::size_t{0}}) {
        int differ = 0, hits = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const Town town(seed);
            const TraceBuild build{.baked_triangles_at_most = baked};
            const auto whole = new_ray_tracer(town.scene, build);
            const auto part = new_ray_tracer(town.scene, build, town.near_ones, 1);
            Random random(seed + 200);
            for (int i = 0; i < 20000; ++i) {
                const auto place = i % 2 == 0 ? Town::on_the_floor : Town::on_an_edge;
                const CameraFrame::Ray ray = town.ray_to(place, random);
                SurfaceHit a, b;
                const bool hit = whole->first_hit(ray, 0, kFar, a);
                ASSERT_EQ(part->first_hit(ray, 0, kFar, b), hit);
                if (!hit) continue;
                ++hits;
                differ += a.position != b.position || a.normal != b.normal || a.depth != b.depth ||
                          a.shading_normal != b.shading_normal || a.offset_m != b.offset_m ||
                          a.front != b.front;
            }
        }
        EXPECT_GT(hits, 70000);
        EXPECT_EQ(differ, 0) << "of " << hits << ", baked at most " << baked;
    }
}

}  // namespace
}  // namespace aoscore
