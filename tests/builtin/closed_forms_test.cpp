#include "scene/builtin/closed_forms.h"

#include "reference/truth.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace aoscore {
namespace {

using namespace closed_form;
using glm::dvec3;

/// Cosine-weighted visibility by brute force: the midpoint rule over equal areas of the unit disc, each of
/// which is one direction of the hemisphere about +y. `distance_to_hit` is infinite where a direction is
/// open.
double integrated(const std::function<double(const dvec3&)>& distance_to_hit, double radius_m = kNoCutoff) {
    constexpr int kRings = 1200, kSpokes = 2400;
    std::int64_t open = 0;
    for (int i = 0; i < kRings; ++i) {
        const double sine = std::sqrt((i + 0.5) / kRings), cosine = std::sqrt(1 - sine * sine);
        for (int k = 0; k < kSpokes; ++k) {
            const double turn = 2 * std::numbers::pi * (k + 0.5) / kSpokes;
            const double t = distance_to_hit({sine * std::cos(turn), cosine, sine * std::sin(turn)});
            if (!(t <= radius_m) || std::isinf(t)) ++open;
        }
    }
    return static_cast<double>(open) / (static_cast<double>(kRings) * kSpokes);
}

constexpr double kIntegrationError = 5e-4;

auto endless_wall(double distance_m, double height_m) {
    return [=](const dvec3& w) {
        if (w.x >= 0) return kNoCutoff;
        const double t = distance_m / -w.x;
        return t * w.y <= height_m ? t : kNoCutoff;
    };
}

TEST(WallForm, AgreesWithIntegration) {
    for (const double distance : {0.1, 0.5, 1.0, 3.0}) {
        for (const double height : {0.5, 1.0, 8.0}) {
            EXPECT_NEAR(wall_visibility(distance, height), integrated(endless_wall(distance, height)),
                        kIntegrationError)
                << distance << ", " << height;
        }
    }
}

TEST(WallForm, HasThePublishedValues) {
    EXPECT_NEAR(wall_visibility(1, 0.5), 0.9472, 5e-5);
    EXPECT_NEAR(wall_visibility(1, 1), 0.8536, 5e-5);
    EXPECT_NEAR(wall_visibility(1, 2), 0.7236, 5e-5);
}

TEST(WallForm, WithCutoffAgreesWithIntegration) {
    for (const double distance : {0.0, 0.1, 0.5, 0.9, 1.0, 2.0}) {
        EXPECT_NEAR(wall_visibility_cutoff(distance, 1), integrated(endless_wall(distance, 100), 1),
                    kIntegrationError)
            << distance;
    }
    EXPECT_DOUBLE_EQ(wall_visibility_cutoff(0, 1), 0.5);
    EXPECT_DOUBLE_EQ(wall_visibility_cutoff(2, 1), 1);
}

TEST(SphereForm, AgreesWithIntegrationForAnyCutoff) {
    const double r = sphere::kRadius_m, height = sphere::kCentreHeight_m;
    for (const double offset : {0.0, 0.4, 1.5}) {
        const dvec3 centre(offset, height, 0);
        const double distance = glm::length(centre), angle = std::acos(height / distance);
        const auto hit = [&](const dvec3& w) {
            const double along = glm::dot(w, centre), off2 = distance * distance - along * along;
            return along > 0 && off2 < r * r ? along - std::sqrt(r * r - off2) : kNoCutoff;
        };
        for (const double radius : {0.2, 0.5, 0.65, 0.9, 1.3, kNoCutoff}) {
            EXPECT_NEAR(sphere_visibility(distance, angle, r, radius), integrated(hit, radius),
                        kIntegrationError)
                << offset << ", " << radius;
        }
    }
}

TEST(PitForm, AgreesWithIntegrationAtEveryPlaceOfTheBottom) {
    const double a = pit::kRadius_m, depth = pit::depth_m();
    for (const double offset : {0.0, 0.3, 0.7, 0.95}) {
        const auto hit = [&](const dvec3& w) {
            // The distance from (offset, 0, 0) to the cylinder x^2 + z^2 = a^2.
            const double flat = w.x * w.x + w.z * w.z, b = offset * w.x;
            const double t = (-b + std::sqrt(b * b + flat * (a * a - offset * offset))) / flat;
            return t * w.y <= depth ? t : kNoCutoff;
        };
        EXPECT_NEAR(pit_visibility_at(offset, a, depth), integrated(hit), kIntegrationError) << offset;
    }
    EXPECT_NEAR(pit_visibility_at(0, a, depth), pit_visibility(pit::kRimZenith_rad), 1e-12);
}

TEST(ExpectedVisibility, IsSilentWhereNoFormHolds) {
    EXPECT_FALSE(expected_visibility("atrium", {0, 0, 0}, 1));
    EXPECT_FALSE(expected_visibility("wall", {1, 0.5, 0}, 1)) << "not on the floor";
    EXPECT_FALSE(expected_visibility("wall", {-0.5, 0, 0}, 1)) << "inside the wall";
    EXPECT_FALSE(expected_visibility("wall", {0.5, 0, 0}, 2)) << "rays reach over the wall's top";
    EXPECT_TRUE(expected_visibility("wall_tall", {0.5, 0, 0}, 2));
    EXPECT_FALSE(expected_visibility("pit", {0, 0, 0}, 1.2)) << "a cut-off between wall and rim";
    EXPECT_FALSE(expected_visibility("pit", {1.5, 0, 0}, kNoCutoff)) << "outside the pit";
    EXPECT_EQ(expected_visibility("pit", {0, 0, 0}, 0.9), 1.0);
    EXPECT_FALSE(expected_visibility("plane", 0.1 * plane::normal(), 1));
}

/// World positions of a frame's surface pixels.
template <class F>
void for_each_point(const CameraFrame& frame, const PrimaryHits& hits, const F& f) {
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            if (hits.surface.at(x, y) == 0) continue;
            const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
            f(x, y, ray.origin + ray.direction * static_cast<double>(hits.depth.at(x, y)));
        }
    }
}

class ClosedFormScenes : public ::testing::TestWithParam<const char*> {};

TEST_P(ClosedFormScenes, ShowTheirFormOnAGoodPartOfEveryView) {
    const Scene scene = load_scene(GetParam());
    const ReferenceScene reference(scene);
    for (const View& view : scene.views) {
        const CameraFrame frame(view.camera, 96, 54);
        ASSERT_TRUE(view.radius_m) << view.id;
        int known = 0;
        for_each_point(frame, reference.primary_hits(frame), [&](int, int, const dvec3& p) {
            known += expected_visibility(GetParam(), p, *view.radius_m).has_value();
        });
        EXPECT_GT(known, 96 * 54 / 4) << view.id;
    }
}

/// Tests the mesh, not only the formula: the view's mean visibility, over so many rays that facets or a wrong
/// dimension of the scene would show.
TEST_P(ClosedFormScenes, MeanTracedVisibilityIsTheFormsWithinFourStandardErrors) {
    const Scene scene = load_scene(GetParam());
    const ReferenceScene reference(scene);
    for (const View& view : scene.views) {
        const CameraFrame frame(view.camera, 96, 54);
        for (const double radius : {*view.radius_m, kNoCutoff}) {
            TruthSettings settings;
            settings.samples = 64;
            const Truth truth =
                reference.trace(frame, {{Falloff::binary, radius, 0}}, settings, "closed form");
            double difference = 0, variance = 0;
            for_each_point(frame, truth.hits, [&](int x, int y, const dvec3& p) {
                const std::optional<double> exact = expected_visibility(GetParam(), p, radius);
                if (!exact) return;
                difference += static_cast<double>(truth.visibility[0].at(x, y)) - *exact;
                variance += *exact * (1 - *exact) / settings.samples;
            });
            const double tessellation = 1e-4 * 96 * 54;
            EXPECT_LE(std::abs(difference), 4 * std::sqrt(variance) + tessellation)
                << view.id << ", R " << radius;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Builtin, ClosedFormScenes,
                         ::testing::Values("plane", "wall", "wall_tall", "sphere", "pit"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace aoscore
