#include "jobs/pixel_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace aoscore {
namespace {

constexpr int kWidth = 64, kHeight = 48;

/// A truth that sees a plane's depth and normal, in view space, through each pixel.
struct Surface {
    double depth;
    glm::vec3 normal;
};
Truth truth_of(const std::function<Surface(int x, int y)>& surface) {
    Truth truth;
    truth.hits.surface = Mask(kWidth, kHeight, 1);
    truth.hits.depth = ImageF(kWidth, kHeight);
    truth.hits.normal = Image<glm::vec3>(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Surface s = surface(x, y);
            truth.hits.depth.at(x, y) = static_cast<float>(s.depth);
            truth.hits.normal.at(x, y) = glm::normalize(s.normal);
        }
    }
    return truth;
}

Camera orthographic() {
    Camera camera;
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = 24;  // A pixel is a metre.
    return camera;
}

TEST(PixelFacts, AStepInDepthIsAnEdgeAndDistancesCountFromIt) {
    const CameraFrame frame(orthographic(), kWidth, kHeight);
    const Truth truth = truth_of([](int x, int) { return Surface{x < 20 ? 10.0 : 30.0, {0, 0, 1}}; });
    const PixelFacts facts = pixel_facts(frame, truth);
    EXPECT_EQ(facts.edge_distance_px.at(19, 10), 0);
    EXPECT_EQ(facts.edge_distance_px.at(20, 10), 0);
    EXPECT_EQ(facts.edge_distance_px.at(25, 10), 5);
    EXPECT_EQ(facts.edge_distance_px.at(0, 10), 19);
    EXPECT_EQ(facts.behind_edge_px.at(20, 10), 0) << "what is farther lies behind the edge";
    EXPECT_EQ(facts.behind_edge_px.at(25, 10), 5);
    EXPECT_EQ(facts.behind_edge_px.at(19, 10), 1);
    EXPECT_EQ(facts.depth_m.pixels, truth.hits.depth.pixels);
    EXPECT_TRUE(facts.causes.empty());
}

TEST(PixelFacts, ASlopeAndACreaseAreNoEdges) {
    const CameraFrame frame(orthographic(), kWidth, kHeight);
    const PixelFacts slope = pixel_facts(frame, truth_of([](int x, int) {
                                             return Surface{10 + 5.0 * x, {5, 0, 1}};
                                         }));
    EXPECT_TRUE(std::isinf(slope.edge_distance_px.at(30, 20)));
    const PixelFacts crease = pixel_facts(
        frame, truth_of([](int x, int) {
            return x < 20 ? Surface{100.0, {0, 0, 1}} : Surface{100 - 4.0 * (x - 19.5), {-4, 0, 1}};
        }));
    EXPECT_TRUE(std::isinf(crease.edge_distance_px.at(30, 20)));
}

TEST(PixelFacts, TheRimOfASurfaceIsAnEdge) {
    const CameraFrame frame(orthographic(), kWidth, kHeight);
    Truth truth = truth_of([](int, int) { return Surface{10, {0, 0, 1}}; });
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 40; x < kWidth; ++x) truth.hits.surface.at(x, y) = 0;
    }
    EXPECT_EQ(pixel_facts(frame, truth).edge_distance_px.at(36, 5), 3);
}

TEST(PixelFacts, TiltIsTheCosineBetweenNormalAndLineOfSight) {
    const CameraFrame frame(orthographic(), kWidth, kHeight);
    const PixelFacts flat = pixel_facts(frame, truth_of([](int, int) { return Surface{10, {0, 0, 1}}; }));
    EXPECT_FLOAT_EQ(flat.tilt.at(3, 40), 1);
    const PixelFacts steep = pixel_facts(frame, truth_of([](int x, int) {
                                             return Surface{10 + 1.0 * x, {1, 0, 1}};
                                         }));
    EXPECT_NEAR(steep.tilt.at(3, 40), std::sqrt(0.5), 1e-6);
    const CameraFrame perspective(Camera{}, kWidth, kHeight);
    const PixelFacts seen = pixel_facts(perspective, truth_of([](int, int) {
                                            return Surface{10, {0, 0, 1}};
                                        }));
    const glm::dvec3 corner = glm::normalize(perspective.view_position(0.5, 0.5, 1));
    EXPECT_NEAR(seen.tilt.at(0, 0), -corner.z, 1e-6);
}

TEST(PixelFacts, CausesAreNamedAndPointIntoTheTruth) {
    Truth truth = truth_of([](int, int) { return Surface{10, {0, 0, 1}}; });
    for (ImageF& image : truth.occlusion_by_cause) image = ImageF(kWidth, kHeight, 0.1F);
    const PixelFacts facts = pixel_facts(CameraFrame(orthographic(), kWidth, kHeight), truth);
    ASSERT_EQ(facts.causes.size(), kCauses);
    for (std::size_t c = 0; c < kCauses; ++c) {
        EXPECT_EQ(facts.causes[c].name, kCauseIds[c]);
        EXPECT_EQ(facts.causes[c].occlusion, &truth.occlusion_by_cause[c]);
    }
}

}  // namespace
}  // namespace aoscore
