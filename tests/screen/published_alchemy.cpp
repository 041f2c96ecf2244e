// Alchemy's estimator as in the programs of two theses.
#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kSigma = 0.128, kKappa = 1.56, kBeta = 0.001, kEpsilon = 1e-4;

// The surface that a tap reads, taken to lie at the tap's place.
dvec3 tapped(const Picture& picture, const dvec2& place) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    const bool inside = x >= 0 && y >= 0 && x < picture.width() && y < picture.height();
    return picture.point(place.x, place.y, inside ? picture.depth(x, y) : picture.far());
}

double obscurance(const dvec3& v, const dvec3& n, double z) {
    return std::max(0.0, glm::dot(v, n) + z * kBeta) / (glm::dot(v, v) + kEpsilon);
}

}  // namespace

Estimator hussain_alchemy(const Picture& picture, const Kernel3& disc, const Noise& noise, double radius) {
    return [&picture, disc, noise, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.face_normal(x, y);
        const double turn = 2 * std::numbers::pi * noise(x, y).x, c = std::cos(turn), s = std::sin(turn);
        const dvec2 reach = 0.75 * radius * radius / -p.z * dvec2(picture.width(), picture.height());
        double sum = 0;
        for (const dvec3& d : disc) {
            const dvec2 turned(c * d.x - s * d.y, s * d.x + c * d.y);
            const dvec3 v = tapped(picture, dvec2(x + 0.5, y + 0.5) + reach * turned) - p;
            if (glm::dot(v, v) <= radius) sum += obscurance(v, n, p.z);
        }
        const double dark = sum * 2 * kSigma / static_cast<double>(disc.size());
        return std::max(0.0, 1 - std::pow(dark, kKappa));
    };
}

Estimator gravas_spiral(const Picture& picture, double radius) {
    return [&picture, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.normal(x, y);
        const dvec2 here(x + 0.5, y + 0.5), size(picture.width(), picture.height());
        const double turn = here.x * 2.3734372915 + here.y * 3.58540627421;
        double sum = 0;
        for (int i = 0; i < 9; ++i) {
            const double alpha = (i + 0.5) / 9, angle = 2 * std::numbers::pi * alpha + turn;
            const dvec2 away = dvec2(std::cos(angle), std::sin(angle)) * alpha * std::min(2.0, radius / -p.z);
            sum += obscurance(tapped(picture, here + away * size) - p, n, p.z);
        }
        return std::pow(std::max(0.0, 1 - sum * 2 * kSigma / 9), kKappa);
    };
}

}  // namespace aoscore::testing::published
