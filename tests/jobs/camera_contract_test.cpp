#include "jobs/camera_contract.h"

#include <gtest/gtest.h>

#include <functional>

namespace aoscore {
namespace {

constexpr int kWidth = 64, kHeight = 48;

CameraFrame frame() {
    Camera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    return {camera, kWidth, kHeight};
}

/// The depth of a surface as a function of pixel position; 0 where there is none.
using DepthOf = std::function<double(double x, double y)>;

// A plane at 5 m that leans back to the right: depth differs at every column, so a shift is a difference.
double leaning_plane(double x, double) {
    return 5.0 / (1.0 - 0.5 * (x / kWidth - 0.5));
}

PrimaryHits hits_of(const DepthOf& depth) {
    PrimaryHits hits{Mask(kWidth, kHeight), ImageF(kWidth, kHeight),
                     Image<glm::vec3>(kWidth, kHeight, glm::vec3(0))};
    const CameraFrame f = frame();
    const auto position = [&](double x, double y) { return f.view_position(x, y, depth(x, y)); };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            if (depth(px, py) <= 0) continue;
            hits.surface.at(x, y) = 1;
            hits.depth.at(x, y) = static_cast<float>(depth(px, py));
            const glm::dvec3 right = position(px + 0.01, py) - position(px - 0.01, py);
            const glm::dvec3 down = position(px, py + 0.01) - position(px, py - 0.01);
            hits.normal.at(x, y) = glm::vec3(glm::normalize(glm::cross(down, right)));
        }
    }
    return hits;
}

GBufferImages gbuffer_of(const DepthOf& depth) {
    GBufferImages gbuffer;
    gbuffer.surface = Mask(kWidth, kHeight);
    ImageF& depth_m = gbuffer.numbers["linear_depth"] = ImageF(kWidth, kHeight, 1000);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (depth(x + 0.5, y + 0.5) <= 0) continue;
            gbuffer.surface.at(x, y) = 1;
            depth_m.at(x, y) = static_cast<float>(depth(x + 0.5, y + 0.5));
        }
    }
    return gbuffer;
}

TEST(CameraContract, EqualSurfacesAgreeEverywhere) {
    const CameraContract contract =
        check_camera_contract(frame(), hits_of(leaning_plane), gbuffer_of(leaning_plane), 10);
    EXPECT_EQ(contract.valid_count, std::size_t{kWidth * kHeight});
    EXPECT_EQ(contract.disagreeing, 0u);
    EXPECT_TRUE(contract.kept());
}

TEST(CameraContract, AShiftByHalfAPixelIsABreach) {
    const auto shifted = [](double x, double y) { return leaning_plane(x + 0.5, y); };
    EXPECT_FALSE(check_camera_contract(frame(), hits_of(leaning_plane), gbuffer_of(shifted), 10).kept());
}

TEST(CameraContract, AMirroredPictureIsABreach) {
    const auto mirrored = [](double x, double y) { return leaning_plane(kWidth - x, y); };
    EXPECT_FALSE(check_camera_contract(frame(), hits_of(leaning_plane), gbuffer_of(mirrored), 10).kept());
}

TEST(CameraContract, DifferencesAtASilhouetteAreMaskedButNoBreach) {
    const auto step = [](double edge_px) {
        return [=](double x, double) { return x < edge_px ? 3.0 : 6.0; };
    };
    const CameraContract contract =
        check_camera_contract(frame(), hits_of(step(30)), gbuffer_of(step(31)), 10);
    EXPECT_EQ(contract.disagreeing, 0u);
    EXPECT_TRUE(contract.kept());
    EXPECT_EQ(contract.valid_count, std::size_t{kWidth * kHeight - kHeight})
        << "one column differs and does not count";
}

TEST(CameraContract, SurfaceThatOnlyOnePathSeesIsABreachAwayFromEdges) {
    const auto hole = [](double x, double y) { return x > 20 && x < 40 && y > 10 && y < 30 ? 0.0 : 5.0; };
    const auto whole = [](double, double) { return 5.0; };
    const CameraContract contract = check_camera_contract(frame(), hits_of(whole), gbuffer_of(hole), 10);
    EXPECT_GT(contract.disagreeing, 300u);
    EXPECT_FALSE(contract.kept());
}

TEST(CameraContract, AnEmptyPictureKeepsIt) {
    const auto nothing = [](double, double) { return 0.0; };
    const CameraContract contract = check_camera_contract(frame(), hits_of(nothing), gbuffer_of(nothing), 10);
    EXPECT_EQ(contract.surface, 0u);
    EXPECT_TRUE(contract.kept());
}

}  // namespace
}  // namespace aoscore
