#include "core/sky.h"

#include "core/sampling.h"
#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

// Midpoints in the square of the sine and around: alike weighted by the cosine, so that an even sky is exact.
double mean_within(const Sky& sky, const glm::dvec3& axis, double cone_rad) {
    constexpr int kRings = 12, kAround = 24;
    constexpr double kTurn = 0.618034;  // of a step from ring to ring, so that no line passes many points
    if (cone_rad <= 0) return sky.radiance(axis);
    const glm::dmat3 frame = frame_about(axis);
    const double most = std::sin(cone_rad) * std::sin(cone_rad);
    double sum = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double sine_squared = most * (ring + 0.5) / kRings;
        const double sine = std::sqrt(sine_squared), cosine = std::sqrt(1 - sine_squared);
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * kPi * (i + kTurn * ring) / kAround;
            sum += sky.radiance(frame * glm::dvec3(sine * std::cos(angle), sine * std::sin(angle), cosine));
        }
    }
    return sum / (kRings * kAround);
}

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
        const double floor = mean_within(scaled, {0, 1, 0}, kPi / 2);
        for (double* term : {&scaled.even, &scaled.upper, &scaled.glow}) *term /= floor;
        return scaled;
    }();
    return sky;
}

SkyCones::SkyCones(const Sky& sky) {
    for (std::vector<double>& map : maps_) map.resize(std::size_t{kRows} * kColumns);
    parallel_for(std::size_t{kRows}, [&](std::size_t row) {
        const double angle = kPi * static_cast<double>(row) / (kRows - 1);
        for (std::size_t column = 0; column < kColumns; ++column) {
            const double around = 2 * kPi * static_cast<double>(column) / kColumns;
            const glm::dvec3 axis(std::sin(angle) * std::cos(around), std::cos(angle),
                                  std::sin(angle) * std::sin(around));
            for (std::size_t map = 0; map < maps_.size(); ++map) {
                maps_[map][row * kColumns + column] =
                    mean_within(sky, axis, kPi / 2 * static_cast<double>(map) / kMaps);
            }
        }
    });
}

double SkyCones::texel(int map, const glm::dvec3& axis) const {
    const double row = std::acos(std::clamp(axis.y, -1.0, 1.0)) / kPi * (kRows - 1);
    double column = std::atan2(axis.z, axis.x) / (2 * kPi) * kColumns;
    if (column < 0) column += kColumns;
    const auto above = std::min(static_cast<std::size_t>(row), std::size_t{kRows - 2});
    const auto left = static_cast<std::size_t>(column) % kColumns, right = (left + 1) % kColumns;
    const double across = column - std::floor(column);
    const std::vector<double>& values = maps_[static_cast<std::size_t>(map)];
    const auto on_row = [&](std::size_t r) {
        return std::lerp(values[r * kColumns + left], values[r * kColumns + right], across);
    };
    return std::lerp(on_row(above), on_row(above + 1), row - static_cast<double>(above));
}

double SkyCones::mean_radiance(const glm::dvec3& axis, double cone_rad) const {
    const double map = std::clamp(cone_rad / (kPi / 2), 0.0, 1.0) * kMaps;
    const int below = std::min(static_cast<int>(map), kMaps - 1);
    return std::lerp(texel(below, axis), texel(below + 1, axis), map - below);
}

}  // namespace aoscore
