#include "core/environment.h"

#include "core/hash.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

/// The texel of `count` that holds a fraction of the picture.
int texel_at(double fraction, int count) {
    return std::clamp(static_cast<int>(std::floor(fraction * count)), 0, count - 1);
}

}  // namespace

double luminance(const glm::dvec3& colour) {
    return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

glm::dvec3 EnvironmentMap::direction(double across, double down) const {
    const double zenith = kPi * down, around = 2 * kPi * (across - 0.5) - turn_rad;
    return {std::sin(zenith) * std::cos(around), std::cos(zenith), std::sin(zenith) * std::sin(around)};
}

const glm::vec3& EnvironmentMap::at(const glm::dvec3& from) const {
    const double down = std::acos(std::clamp(from.y, -1.0, 1.0)) / kPi;
    const double across = (std::atan2(from.z, from.x) + turn_rad) / (2 * kPi) + 0.5;
    return radiance.at(texel_at(across - std::floor(across), radiance.width),
                       texel_at(down, radiance.height));
}

double EnvironmentMap::solid_angle(int row) const {
    const double above = std::cos(kPi * row / radiance.height);
    const double below = std::cos(kPi * (row + 1) / radiance.height);
    return 2 * kPi / radiance.width * (above - below);
}

EnvironmentMap EnvironmentMap::reduced(int width) const {
    int step = (radiance.width + width - 1) / width;
    while (step > 1 && (radiance.width % step != 0 || radiance.height % step != 0)) ++step;
    if (step <= 1 || step > radiance.height) return *this;
    EnvironmentMap small{Image<glm::vec3>(radiance.width / step, radiance.height / step), turn_rad};
    for (int y = 0; y < small.radiance.height; ++y) {
        for (int x = 0; x < small.radiance.width; ++x) {
            glm::dvec3 sum(0);
            for (int row = y * step; row < (y + 1) * step; ++row) {
                for (int column = x * step; column < (x + 1) * step; ++column)
                    sum += solid_angle(row) * glm::dvec3(radiance.at(column, row));
            }
            small.radiance.at(x, y) = glm::vec3(sum / small.solid_angle(y));
        }
    }
    return small;
}

glm::dvec3 Environment::radiance(const glm::dvec3& from) const {
    if (const EnvironmentMap* picture = map()) return glm::dvec3(picture->at(from));
    return glm::dvec3(sky()->radiance(from));
}

std::string Environment::digest() const {
    Digest digest;
    if (const EnvironmentMap* picture = map()) {
        digest.text("map").value(picture->turn_rad).value(picture->radiance.width);
        digest.array(std::span(picture->radiance.pixels));
        return digest.hex();
    }
    const Sky& terms = *sky();
    digest.text("sky").value(terms.even).value(terms.slope).value(terms.upper).value(terms.glow);
    digest.value(terms.glow_sharpness)
        .value(terms.glow_from.x)
        .value(terms.glow_from.y)
        .value(terms.glow_from.z);
    return digest.hex();
}

}  // namespace aoscore
