#include "metrics/measures/flip_colour.h"

#include "metrics/measures/power_of_lanes.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kExponent = 0.7;
constexpr double kKnee = 0.4, kAtKnee = 0.95;

/// CIELAB's L* of a luminance in [0,1]; `root` is its cube root, which may be NaN for 0.
[[gnu::always_inline]] inline double lightness(double luminance, double root) {
    constexpr double kDelta = 6.0 / 29;
    const double line = luminance * (1 / (3 * kDelta * kDelta)) + 4.0 / 29;
    return 116 * lanes::if_less(luminance, kDelta * kDelta * kDelta, line, root) - 16;
}

double lightness(double luminance) {
    return lightness(luminance, std::cbrt(luminance));
}

struct Lab {
    double l, a, b;
};

/// CIELAB of a colour given by its luminance and its X and Z relative to white's, with the Hunt effect:
/// colours fade in the dark.
Lab hunt_adjusted_lab(double relative_x, double y, double relative_z) {
    const double l = lightness(y);
    const double a = 500.0 / 116 * (lightness(relative_x) - l), b = 200.0 / 116 * (l - lightness(relative_z));
    return {l, 0.01 * l * a, 0.01 * l * b};
}

/// The largest colour difference, from sRGB's green to its blue, by which all are divided.
double largest_color_difference() {
    constexpr double kWhiteX = 0.9504700, kWhiteZ = 1.0888300;
    const Lab green = hunt_adjusted_lab(0.3575761 / kWhiteX, 0.7151522, 0.1191920 / kWhiteZ);
    const Lab blue = hunt_adjusted_lab(0.1804375 / kWhiteX, 0.0721750, 0.9503041 / kWhiteZ);
    const double hyab = std::abs(green.l - blue.l) + std::hypot(green.a - blue.a, green.b - blue.b);
    return std::pow(hyab, kExponent);
}

/// The curve of a raised difference: steep below the knee, flat beyond it, up to 1 at the largest.
struct Curve {
    double knee, knee_lightness;  ///< the knee, and the difference of L* that is raised to it
    double below, log2_below;     ///< the slope below it
    double above;                 ///< the slope beyond it

    Curve() {
        const double largest = largest_color_difference();
        knee = kKnee * largest;
        knee_lightness = std::pow(knee, 1 / kExponent);
        below = kAtKnee / knee;
        log2_below = std::log2(below);
        above = (1 - kAtKnee) / (largest - knee);
    }
};

[[gnu::always_inline]] inline double exponent_at(const SeenRow& a, const SeenRow& b, std::size_t i) {
    const double feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    return std::max(1 - std::sqrt(feature / std::numbers::sqrt2), 0.0);
}

[[gnu::always_inline]] inline double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// FLIP of the pixels whose lightness differs by less than at the knee, where a product of powers needs one
/// logarithm alone; whether there are others.
AOSCORE_WIDER_WHERE_POSSIBLE
bool find_small_differences(const Curve& curve, const SeenRow& truth, const SeenRow& test,
                            double* differences, std::size_t count) {
    const double knee = curve.knee_lightness, log2_below = curve.log2_below;
    std::uint64_t others = 0;
    AOSCORE_NO_ROW_OVERLAPS
    for (std::size_t i = 0; i < count; ++i) {
        const double light = std::abs(truth.lightness[i] - test.lightness[i]);
        others |= 1 - lanes::is_less(light, knee);
        differences[i] =
            power_by_log2(light, log2_below + kExponent * log2_of(light), exponent_at(truth, test, i));
    }
    return others != 0;
}

/// FLIP of the other pixels.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_large_differences(const Curve& curve, const SeenRow& truth, const SeenRow& test,
                            double* differences, std::size_t count) {
    const double at_knee = curve.knee, knee = curve.knee_lightness, above = curve.above;
    for (std::size_t i = 0; i < count; ++i) {
        const double light = std::abs(truth.lightness[i] - test.lightness[i]);
        const double large = kAtKnee + (power(light, kExponent) - at_knee) * above;
        const double raised = power(large, exponent_at(truth, test, i));
        differences[i] = light < knee ? differences[i] : raised;
    }
}

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void find_features(const ResponseRow& responses, const FeatureRow& features, std::size_t count) {
    AOSCORE_NO_ROW_OVERLAPS
    for (std::size_t i = 0; i < count; ++i) {
        const double luminance = std::min(std::max(responses.seen[i], 0.0), 1.0);
        features.lightness[i] = lightness(luminance, cube_root(luminance));
        features.edges[i] = length(responses.edge_x[i], responses.edge_y[i]);
        features.points[i] = length(responses.point_x[i], responses.point_y[i]);
    }
}

void flip_differences(std::span<double> differences, const SeenRow& truth, const SeenRow& test) {
    static const Curve curve;
    if (find_small_differences(curve, truth, test, differences.data(), differences.size()))
        find_large_differences(curve, truth, test, differences.data(), differences.size());
}

}  // namespace aoscore
