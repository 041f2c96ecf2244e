#include "metrics/measures/flip_colour.h"

#include "metrics/measures/power.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace aoscore {
namespace {

constexpr double kExponent = 0.7;
constexpr double kKnee = 0.4, kAtKnee = 0.95;

/// CIELAB's L* of a luminance in [0,1]; `root` is its cube root.
double lightness(double luminance, double root) {
    constexpr double kDelta = 6.0 / 29;
    const double curve =
        luminance > kDelta * kDelta * kDelta ? root : luminance / (3 * kDelta * kDelta) + 4.0 / 29;
    return 116 * curve - 16;
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

void to_lightness(std::span<double> luminances) {
    for (double& luminance : luminances) luminance = std::clamp(luminance, 0.0, 1.0);
    std::vector<double> roots(luminances.begin(), luminances.end());
    raise(roots, 1.0 / 3);
    for (std::size_t i = 0; i < roots.size(); ++i) luminances[i] = lightness(luminances[i], roots[i]);
}

void flip_color_differences(std::span<double> differences, const double* truth, const double* test) {
    static const double largest = largest_color_difference();
    static const double knee = kKnee * largest;
    for (std::size_t i = 0; i < differences.size(); ++i)
        differences[i] = std::abs(truth[i] - test[i]);  // HyAB for grays
    raise(differences, kExponent);
    for (double& difference : differences) {
        difference = difference < knee ? kAtKnee / knee * difference
                                       : kAtKnee + (difference - knee) / (largest - knee) * (1 - kAtKnee);
    }
}

}  // namespace aoscore
