#include "reference/tracer/reach.h"

#include "core/sampling.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace aoscore {
namespace {

constexpr TraceBuild kWhole{.leave_out_of_reach = false};

Mesh box(const glm::dvec3& low, const glm::dvec3& high) {
    Mesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Random numbers in [-1, 1].
auto random_numbers(std::uint64_t seed) {
    return [state = seed * 100000]() mutable {
        return static_cast<double>(mix_bits(state++) >> 11) * 0x1p-53 * 2 - 1;
    };
}

/// Floor tiles with some hundred balls and boxes on and over them, at random places.
Scene field(std::uint64_t seed) {
    Scene scene = testing::empty_scene();
    scene.meshes = {testing::floor_grid(1, 3), testing::sphere({0, 0, 0}, 1, 5),
                    box({-1, -2, -1}, {2, 1, 1})};
    for (int z = -4; z <= 4; ++z) {
        for (int x = -4; x <= 4; ++x)
            scene.instances.push_back({0, glm::translate(glm::dmat4(1), {2.0 * x, 0.0, 2.0 * z})});
    }
    auto random = random_numbers(seed);
    for (int i = 0; i < 300; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {9 * random(), 0.7 + 0.7 * random(), 9 * random()});
        m = glm::rotate(m, 3 * random(), glm::normalize(glm::dvec3(random(), random(), 1.5)));
        m = glm::scale(m, {0.2 + 0.15 * random(), 0.2 + 0.15 * random(), 0.2 + 0.15 * random()});
        scene.instances.push_back({1 + i % 2, m});
    }
    return scene;
}

Camera somewhere(std::uint64_t seed, Camera::Projection projection) {
    auto random = random_numbers(seed + 50);
    const glm::dvec3 position(6 * random(), 1.5 + random(), 6 * random());
    Camera camera = testing::looking(position, position + glm::dvec3(random(), -0.4, random()), 0.8);
    camera.projection = projection;
    camera.half_height = 1.5;
    camera.near = 0.2;
    camera.far = 9;
    return camera;
}

void expect_same_bits(const Truth& a, const Truth& b, const std::string& what) {
    for (std::size_t q = 0; q < a.queries.size(); ++q) {
        EXPECT_EQ(a.visibility[q].pixels, b.visibility[q].pixels) << what;
        EXPECT_EQ(a.standard_error[q].pixels, b.standard_error[q].pixels) << what;
    }
    for (std::size_t c = 0; c < kCauses; ++c)
        EXPECT_EQ(a.occlusion_by_cause[c].pixels, b.occlusion_by_cause[c].pixels) << what;
    EXPECT_EQ(a.one_layer_bound.pixels, b.one_layer_bound.pixels) << what;
    EXPECT_EQ(a.bent_normal.pixels, b.bent_normal.pixels) << what;
    EXPECT_EQ(a.hits.depth.pixels, b.hits.depth.pixels) << what;
    EXPECT_EQ(a.hits.normal.pixels, b.hits.normal.pixels) << what;
    EXPECT_EQ(a.sample_counts.pixels, b.sample_counts.pixels) << what;
    EXPECT_EQ(a.open_pixels, b.open_pixels) << what;
}

class LeftOut : public ::testing::TestWithParam<Camera::Projection> {};

TEST_P(LeftOut, InstancesOutOfReachChangeNoBit) {
    std::uint64_t left_out = 0, open = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Scene scene = field(seed);
        const CameraFrame frame(somewhere(seed, GetParam()), 96, 64);
        for (const std::size_t baked : {std::size_t{2'000'000}, std::size_t{0}}) {
            for (const double radius_m : {0.05, 0.3, 1.0}) {
                TruthSettings settings;
                settings.extras = seed % 2 == 0 ? TruthExtras{true, true, true} : TruthExtras{};
                const std::vector<TruthQuery> queries = {{Falloff::binary, radius_m, 0}};
                const auto truth = [&](const TraceBuild& build) {
                    return ReferenceScene::built_when_needed(scene, build)
                        .trace(frame, queries, settings, "reach");
                };
                const Truth whole = truth({baked, false}), part = truth({baked, true});
                expect_same_bits(whole, part, "seed " + std::to_string(seed));
                EXPECT_EQ(whole.left_out_triangles, 0u);
                left_out += part.left_out_triangles;
                open += part.open_pixels;
            }
        }
    }
    EXPECT_GT(left_out, 200'000u);
    EXPECT_GT(open, 1000u) << "what is proven open must be the same as well";
}

TEST_P(LeftOut, AnsweringSeveralQueriesReachesAsFarAsTheFarthest) {
    const Scene scene = field(7);
    const CameraFrame frame(somewhere(7, GetParam()), 96, 64);
    TruthSettings settings;
    settings.max_error = 0.05;
    const std::vector<TruthQuery> queries = {
        {Falloff::quadratic, 0.1, 0}, {Falloff::alchemy, 1.2, 0.1}, {Falloff::xegtao, 0.4, 0}};
    const auto truth = [&](const TraceBuild& build) {
        return ReferenceScene::built_when_needed(scene, build).trace(frame, queries, settings, "reach");
    };
    const Truth part = truth({});
    expect_same_bits(truth(kWhole), part, "several");
    EXPECT_GT(part.left_out_triangles, 0u);
}

INSTANTIATE_TEST_SUITE_P(Projections, LeftOut,
                         ::testing::Values(Camera::Projection::perspective, Camera::Projection::orthographic),
                         [](const auto& tested) {
                             return tested.param == Camera::Projection::perspective ? "perspective"
                                                                                    : "orthographic";
                         });

class EveryView : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryView, HasTheSameBitsWithoutWhatIsOutOfItsReach) {
    const Scene scene = load_scene(GetParam());
    const ReferenceScene whole(scene);
    TruthSettings settings;
    settings.samples = 32;
    settings.extras = {true, true, true};
    for (const View& view : scene.views) {
        const CameraFrame frame(view.camera, 80, 45);
        const double radius_m = view.radius_m.value_or(0.5);
        for (const double times : {0.2, 1.0, 4.0}) {
            const std::vector<TruthQuery> queries = {{Falloff::binary, times * radius_m, 0}};
            const std::vector<char> within = Reach(scene).instances(frame, times * radius_m);
            if (std::ranges::count(within, 0) == 0) continue;
            const Truth part =
                ReferenceScene::built_when_needed(scene).trace(frame, queries, settings, "part");
            expect_same_bits(whole.trace(frame, queries, settings, "whole"), part,
                             view.id + ", radius " + std::to_string(times * radius_m));
        }
    }
}

std::vector<std::string> ids_of_builtin_scenes() {
    std::vector<std::string> ids;
    for (const BuiltinScene& scene : builtin_scenes()) ids.emplace_back(scene.id);
    return ids;
}

INSTANTIATE_TEST_SUITE_P(BuiltInScenes, EveryView, ::testing::ValuesIn(ids_of_builtin_scenes()),
                         [](const auto& tested) { return tested.param; });

/// A floor that ends below the lower edge of the picture, where it is cut at z = 0, and boxes of 0.2 m that
/// stand behind it in steps of 0.5 m, towards and beyond the camera.
struct Row {
    Row() {
        testing::add(scene, testing::quad({-2, 0, -8}, {2, 0, -8}, {2, 0, 0}, {-2, 0, 0}));
        testing::add(scene, box({-0.1, 0, 0}, {0.1, 0.2, 0.2}));
        scene.instances.pop_back();
        for (int i = 0; i < 10; ++i)
            scene.instances.push_back({1, glm::translate(glm::dmat4(1), {0.0, 0.0, 0.1 + 0.5 * i})});
    }
    /// Looks along -z, orthographically, from the plane z = 0, bounded by near and far plane.
    CameraFrame frame() const {
        Camera camera = testing::looking({0, 1, 0.5}, {0, 1, -1});
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = 2;
        camera.near = 0.5;
        camera.far = 20;
        return {camera, 64, 64};
    }
    /// The boxes of the ten that are within the radius, in their order.
    std::vector<char> boxes(double reach_m) const {
        std::vector<char> within = Reach(scene).instances(frame(), reach_m);
        EXPECT_EQ(within.at(0), 1) << "the floor";
        within.erase(within.begin());
        return within;
    }
    Scene scene = testing::empty_scene();
};

TEST(Reach, KeepsTheBoxesBehindTheCameraThatAreWithinReachAndNoOthers) {
    const Row row;
    EXPECT_EQ(row.boxes(0.05), std::vector<char>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row.boxes(0.12), std::vector<char>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row.boxes(0.55), std::vector<char>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row.boxes(1.11), std::vector<char>({1, 1, 1, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row.boxes(INFINITY), std::vector<char>({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Reach, LooksAtAllSidesOfThePicture) {
    Scene scene = testing::empty_scene();
    testing::add(scene, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
    const Mesh cube = scene.meshes[0];
    // Points in view space; the picture is 2 x 1 half heights wide and high at z = -4, near is 1, far 9.
    const std::vector<glm::dvec3> just_outside{{-4.9, 0, -4}, {4.9, 0, -4}, {0, -2.7, -4},
                                               {0, 2.7, -4},  {0, 0, -0.3}, {0, 0, -9.7}};
    for (const Camera::Projection projection :
         {Camera::Projection::perspective, Camera::Projection::orthographic}) {
        Camera camera = testing::looking({0, 0, 0}, {0, 0, -1}, 2 * std::atan(0.5));
        camera.projection = projection;
        camera.half_height = 2;
        camera.near = 1;
        camera.far = 9;
        const CameraFrame frame(camera, 64, 32);
        for (const glm::dvec3& place : just_outside) {
            scene.instances = {{0, glm::translate(glm::dmat4(1), place)}};
            EXPECT_EQ(Reach(scene).instances(frame, 0.3).at(0), 0) << place.x << ' ' << place.y << place.z;
            EXPECT_EQ(Reach(scene).instances(frame, 0.9).at(0), 1) << place.x << ' ' << place.y << place.z;
        }
    }
}

TEST(Reach, LeftOutTrianglesAreThoseOfTheInstancesThatWereNotBuilt) {
    const Row row;
    const ReferenceScene reference = ReferenceScene::built_when_needed(row.scene);
    const auto left_out = [&](double radius_m) {
        return reference.trace(row.frame(), {{Falloff::binary, radius_m, 0}}, {}, "row").left_out_triangles;
    };
    EXPECT_EQ(left_out(1.11), 7u * 12u);
    EXPECT_EQ(left_out(1.11), 0u) << "nothing was built for it";
    EXPECT_EQ(left_out(0.12), 0u) << "what is there has all it takes";
    EXPECT_EQ(left_out(INFINITY), 0u);
    EXPECT_EQ(left_out(1.11), 0u);
}

TEST(Reach, PictureOfNothingTakesNothing) {
    const Row row;
    const CameraFrame frame(testing::looking({0, 1, 10}, {0, 1, 20}), 32, 32);
    const ReferenceScene reference = ReferenceScene::built_when_needed(row.scene);
    const Truth truth = reference.trace(frame, {{Falloff::binary, 1, 0}}, {}, "nothing");
    EXPECT_EQ(truth.rays, 0u);
    EXPECT_EQ(truth.left_out_triangles, 2u + 10u * 12u);
}

TEST(Reach, SceneBuiltAtOnceIsWhole) {
    const Row row;
    EXPECT_EQ(ReferenceScene(row.scene)
                  .trace(row.frame(), {{Falloff::binary, 0.12, 0}}, {}, "row")
                  .left_out_triangles,
              0u);
}

TEST(Reach, AnotherViewGetsWhatItSees) {
    const Scene scene = field(9);
    const ReferenceScene shared = ReferenceScene::built_when_needed(scene);
    const std::vector<TruthQuery> queries = {{Falloff::binary, 0.3, 0}};
    std::size_t bytes = 0;
    for (std::uint64_t seed = 20; seed < 26; ++seed) {
        const CameraFrame frame(somewhere(seed, Camera::Projection::perspective), 64, 48);
        const Truth whole =
            ReferenceScene::built_when_needed(scene, kWhole).trace(frame, queries, {}, "whole");
        expect_same_bits(whole, shared.trace(frame, queries, {}, "part"), std::to_string(seed));
        EXPECT_EQ(shared.primary_hits(frame).depth.pixels, whole.hits.depth.pixels);
        EXPECT_GE(shared.peak_bytes(), bytes);
        bytes = shared.peak_bytes();
    }
}

}  // namespace
}  // namespace aoscore
