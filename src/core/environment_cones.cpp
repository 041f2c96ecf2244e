#include "core/environment_cones.h"

#include "core/sampling.h"
#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;
using Means = std::array<glm::dvec3, EnvironmentCones::kMaps + 1>;

double half_angle(std::size_t map) {
    return kPi / 2 * static_cast<double>(map) / EnvironmentCones::kMaps;
}

/// A texel of a picture as a source of light.
struct Source {
    glm::dvec3 from, radiance;
    double solid_angle;
};

/// The same light in texels of at least `width` a row: each texel is an area of even light, which the one
/// direction of its centre cannot stand for where texels are few.
EnvironmentMap divided(const EnvironmentMap& map, int width) {
    const int parts = (width + map.radiance.width - 1) / map.radiance.width;
    EnvironmentMap fine{Image<glm::vec3>(map.radiance.width * parts, map.radiance.height * parts),
                        map.turn_rad};
    for (int y = 0; y < fine.radiance.height; ++y) {
        for (int x = 0; x < fine.radiance.width; ++x)
            fine.radiance.at(x, y) = map.radiance.at(x / parts, y / parts);
    }
    return fine;
}

/// The texels of a picture, of a size that the smallest cone tells apart and no smaller.
std::vector<Source> sources_of(const EnvironmentMap& picture) {
    constexpr int kLeast = 256, kMost = 512;  // 0.7 degrees: a sixteenth of the smallest cone's half angle
    const EnvironmentMap map = divided(picture.reduced(kMost), kLeast);
    std::vector<Source> sources;
    for (int y = 0; y < map.radiance.height; ++y) {
        for (int x = 0; x < map.radiance.width; ++x) {
            sources.push_back({map.direction((x + 0.5) / map.radiance.width, (y + 0.5) / map.radiance.height),
                               glm::dvec3(map.radiance.at(x, y)), map.solid_angle(y)});
        }
    }
    return sources;
}

/// Sums over all texels, each in the smallest cone that holds its centre, then from cone to cone. Means are
/// over the weights that were met, so that an even picture is exact; a cone that holds no centre has the
/// radiance on its axis.
Means means_of(const std::vector<Source>& sources, const Environment& environment, const glm::dvec3& axis) {
    std::array<double, std::tuple_size_v<Means>> cosines{}, weights{};
    for (std::size_t map = 0; map < cosines.size(); ++map) cosines[map] = std::cos(half_angle(map));
    Means means{};
    for (const Source& source : sources) {
        const double cosine = glm::dot(source.from, axis);
        if (cosine <= 0) continue;
        std::size_t map = cosines.size() - 1;
        while (map > 0 && cosine >= cosines[map - 1]) --map;
        const double weight = cosine * source.solid_angle;
        weights[map] += weight;
        means[map] += weight * source.radiance;
    }
    for (std::size_t map = 1; map < means.size(); ++map) {
        weights[map] += weights[map - 1];
        means[map] += means[map - 1];
    }
    for (std::size_t map = 0; map < means.size(); ++map)
        means[map] = weights[map] > 0 ? means[map] / weights[map] : environment.radiance(axis);
    means[0] = environment.radiance(axis);
    return means;
}

Means means_of_sky(const Sky& sky, const glm::dvec3& axis) {
    Means means;
    for (std::size_t map = 0; map < means.size(); ++map)
        means[map] = glm::dvec3(mean_within(sky, axis, half_angle(map)));
    return means;
}

}  // namespace

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

EnvironmentCones::EnvironmentCones(const Environment& environment) {
    std::vector<Source> sources;
    if (environment.map() != nullptr) sources = sources_of(*environment.map());
    for (auto& map : maps_) map.resize(std::size_t{kRows} * kColumns);
    parallel_for(std::size_t{kRows}, [&](std::size_t row) {
        const double angle = kPi * static_cast<double>(row) / (kRows - 1);
        for (std::size_t column = 0; column < kColumns; ++column) {
            const double around = 2 * kPi * static_cast<double>(column) / kColumns;
            const glm::dvec3 axis(std::sin(angle) * std::cos(around), std::cos(angle),
                                  std::sin(angle) * std::sin(around));
            const Means means = environment.sky() != nullptr ? means_of_sky(*environment.sky(), axis)
                                                             : means_of(sources, environment, axis);
            for (std::size_t map = 0; map < maps_.size(); ++map)
                maps_[map][row * kColumns + column] = means[map];
        }
    });
}

glm::dvec3 EnvironmentCones::texel(int map, const glm::dvec3& axis) const {
    const double row = std::acos(std::clamp(axis.y, -1.0, 1.0)) / kPi * (kRows - 1);
    double column = std::atan2(axis.z, axis.x) / (2 * kPi) * kColumns;
    if (column < 0) column += kColumns;
    const auto above = std::min(static_cast<std::size_t>(row), std::size_t{kRows - 2});
    const auto left = static_cast<std::size_t>(column) % kColumns, right = (left + 1) % kColumns;
    const double across = column - std::floor(column);
    const std::vector<glm::dvec3>& values = maps_[static_cast<std::size_t>(map)];
    const auto on_row = [&](std::size_t r) {
        return glm::mix(values[r * kColumns + left], values[r * kColumns + right], across);
    };
    return glm::mix(on_row(above), on_row(above + 1), row - static_cast<double>(above));
}

glm::dvec3 EnvironmentCones::mean_radiance(const glm::dvec3& axis, double cone_rad) const {
    const double map = std::clamp(cone_rad / (kPi / 2), 0.0, 1.0) * kMaps;
    const int below = std::min(static_cast<int>(map), kMaps - 1);
    return glm::mix(texel(below, axis), texel(below + 1, axis), map - below);
}

}  // namespace aoscore
