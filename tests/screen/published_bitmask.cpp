#include "published_methods.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;

struct Bitmask {
    const Picture& picture;
    DepthLevels levels;
    Noise noise;
    double radius, thickness;

    double operator()(int px, int py) const {
        const dvec3 p = picture.point(px, py), n = picture.normal(px, py), view = glm::normalize(-p);
        const double at = 0.06711056 * px + 0.00583715 * py, inner = 52.9829189 * (at - std::floor(at));
        const double azimuth = (inner - std::floor(inner)) * kPi;
        const double start = 0.25 * (((py - px) % 4 + 4) % 4) + 2 * noise(px, py).x - 1;
        const dvec2 direction(std::cos(azimuth), std::sin(azimuth));
        // The half circle about the normal's part in the slice, as angles from the view vector toward
        // `direction`.
        const dvec3 along(direction.x, -direction.y, 0);
        const dvec3 u = glm::normalize(along - view * glm::dot(along, view));
        const double low = std::atan2(glm::dot(n, u), glm::dot(n, view)) - kPi / 2;
        const double reach = std::max(radius * picture.pixels_per_metre(-p.z) / 2, 12.0) / 13;
        std::bitset<32> hidden;
        for (const int side : {1, -1}) {
            for (int j = 0; j < 12; ++j) {
                const dvec2 place = dvec2(px + 0.5, py + 0.5) +
                                    direction * (side * std::max(std::abs(j + start) * reach, j + 1.0));
                if (place.x <= 0 || place.y <= 0 || place.x >= picture.width() || place.y >= picture.height())
                    continue;
                const double depth = levels.depth(std::min((j + 1) / 2, 4), static_cast<int>(place.x),
                                                  static_cast<int>(place.y));
                const dvec3 front = picture.point(place.x, place.y, depth) - p,
                            back = front - thickness * view;
                const auto place_of = [&](const dvec3& v) {
                    const double angle =
                        side * std::acos(std::clamp(glm::dot(v, view) / glm::length(v), -1.0, 1.0));
                    return std::clamp((angle - low) / kPi, 0.0, 1.0);
                };
                const double a = std::min(place_of(front), place_of(back)),
                             b = std::max(place_of(front), place_of(back));
                const int first = static_cast<int>(a * 32), count = static_cast<int>(std::ceil((b - a) * 32));
                for (int bit = first; bit < std::min(first + count, 32); ++bit)
                    hidden.set(static_cast<std::size_t>(bit));
            }
        }
        return 1 - static_cast<double>(hidden.count()) / 32;
    }
};

}  // namespace

Estimator visibility_bitmask(const Picture& picture, const Noise& noise, double radius, double thickness) {
    return Bitmask{picture, DepthLevels(picture, rotated_pick), noise, radius, thickness};
}

}  // namespace aoscore::testing::published
