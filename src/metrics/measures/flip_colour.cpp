#include "metrics/measures/flip_colour.h"

#include "metrics/measures/power_of_lanes.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kExponent = 0.7;
constexpr double kKnee = 0.4, kAtKnee = 0.95;

/// CIELAB's L* of a luminance in [0,1]; `root` is its cube root.
[[gnu::always_inline]] inline double lightness(double luminance, double root) {
    constexpr double kDelta = 6.0 / 29;
    const double line = luminance * (1 / (3 * kDelta * kDelta)) + 4.0 / 29;
    return 116 * (luminance > kDelta * kDelta * kDelta ? root : line) - 16;
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

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void to_lightness(std::span<double> luminances) {
    double* luminance = luminances.data();
    for (std::size_t i = 0; i < luminances.size(); ++i) {
        const double clamped = std::min(std::max(luminance[i], 0.0), 1.0);
        luminance[i] = lightness(clamped, power(clamped, 1.0 / 3));
    }
}

AOSCORE_WIDER_WHERE_POSSIBLE
void flip_differences(std::span<double> differences, const SeenRow& truth, const SeenRow& test) {
    static const double largest = largest_color_difference();
    const double knee = kKnee * largest;
    const double below = kAtKnee / knee, above = (1 - kAtKnee) / (largest - knee);
    double* difference = differences.data();
    const double *light = truth.lightness, *other_light = test.lightness;
    const double *edge = truth.edges, *other_edge = test.edges;
    const double *point = truth.points, *other_point = test.points;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const double hyab = power(std::abs(light[i] - other_light[i]), kExponent);  // of grays
        const double small = below * hyab, large = kAtKnee + (hyab - knee) * above;
        const double feature =
            std::max(std::abs(edge[i] - other_edge[i]), std::abs(point[i] - other_point[i]));
        const double exponent = std::max(1 - std::sqrt(feature / std::numbers::sqrt2), 0.0);
        difference[i] = power(hyab < knee ? small : large, exponent);
    }
}

}  // namespace aoscore
