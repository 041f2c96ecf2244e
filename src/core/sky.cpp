#include "core/sky.h"

#include "core/environment_cones.h"

#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

Sky unscaled_sky() {
    return {.even = 0.15, .upper = 0.35, .glow = 2};
}

}  // namespace

double Sky::radiance(const glm::dvec3& from) const {
    double sum = even + slope * from.y;
    if (from.y > 0) sum += upper;
    if (glow != 0) sum += glow * std::exp(glow_sharpness * (glm::dot(from, glow_from) - 1));
    return sum;
}

const Sky& generated_sky() {
    static const Sky sky = [] {
        Sky scaled = unscaled_sky();
        const double floor = mean_within(scaled, {0, 1, 0}, std::numbers::pi / 2);
        for (double* term : {&scaled.even, &scaled.upper, &scaled.glow}) *term /= floor;
        return scaled;
    }();
    return sky;
}

}  // namespace aoscore
