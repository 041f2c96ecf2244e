#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

[[gnu::noinline]] glm::dvec3 through_float(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

// Offsets against self-hits, depths and the camera contract rely on this rounding; see cmake/Rooms.cmake.
TEST(Rounding, DoublesThatPassThroughFloatAreRounded) {
    const glm::dvec3 rounded = through_float({0.1, 0.2, 0.3});
    EXPECT_EQ(rounded.x, static_cast<double>(0.1f));
    EXPECT_EQ(rounded.y, static_cast<double>(0.2f));
    EXPECT_EQ(rounded.z, static_cast<double>(0.3f));
}

}  // namespace
}  // namespace aoscore
