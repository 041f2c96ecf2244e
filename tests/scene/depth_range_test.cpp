#include "scene/depth_range.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(DepthRange, KeepsTheFurthestCornerBeforeTheBackgroundInFloat32) {
    // Window depth is far (z - near) / (z (far - near)), and 1 where there is nothing.
    Camera camera;
    camera.position = {0, 0, 3.4};
    camera.target = {0, 0, 0};
    const double furthest = 4.4;
    for (const double scale : {1e-4, 1.0, 1e4}) {
        Camera scaled = camera;
        scaled.position *= scale;
        const Bounds bounds{glm::dvec3(-scale), glm::dvec3(scale)};
        for (const double stated_near : {0.0, 1e-9 * scale, 0.1 * scale}) {
            const DepthRange range = useful_depth_range(scaled, bounds, stated_near, 0);
            const double z = furthest * scale;
            const double window = range.far * (z - range.near) / (z * (range.far - range.near));
            EXPECT_LT(static_cast<float>(window), 1 - 0x4p-24F) << scale << ", near " << stated_near;
        }
    }
}

}  // namespace
}  // namespace aoscore
