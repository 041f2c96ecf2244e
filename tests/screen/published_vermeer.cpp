// Vermeer, Stochastic-Depth Ambient Occlusion, 2020: algorithms 1 to 3, normals from differences of depth.
#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kDirections = 4, kSteps = 4;

// The depth at a place, and the background's outside of the picture.
double depth_at(const Picture& picture, const dvec2& place) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    const bool inside = x >= 0 && y >= 0 && x < picture.width() && y < picture.height();
    return inside ? picture.depth(x, y) : picture.far();
}

// The surface's point in the texel of a place.
dvec3 surface_at(const Picture& picture, const dvec2& place) {
    return picture.point(std::floor(place.x) + 0.5, std::floor(place.y) + 0.5, depth_at(picture, place));
}

// Sums `along` over the marched directions; it gets the direction in view space and the vectors from the
// pixel to the steps.
double sum_over_directions(
    const Picture& picture, const Noise& noise, double radius, int x, int y,
    const std::function<double(const dvec3& direction, const dvec3 (&steps)[kSteps])>& along) {
    const dvec3 p = picture.point(x, y);
    const glm::dvec4 xi = noise(x, y);
    const double step = radius * picture.pixels_per_metre(-p.z) / (kSteps + 1);
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = (i + xi.x) * 2 * std::numbers::pi / kDirections;
        const dvec2 d(std::cos(angle), std::sin(angle));
        dvec3 steps[kSteps];
        for (int j = 0; j < kSteps; ++j)
            steps[j] = surface_at(picture, dvec2(x + 0.5, y + 0.5) + d * ((j + 1 + xi.y) * step)) - p;
        sum += along({d.x, -d.y, 0}, steps);
    }
    return sum;
}

double falloff(const dvec3& v, double radius) {
    return 1 - glm::dot(v, v) / (radius * radius);
}

}  // namespace

Estimator vermeer_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius) {
    return [&picture, kernel, noise, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.face_normal(x, y);
        const double turn = 2 * std::numbers::pi * noise(x, y).x;
        const dvec3 toward(std::cos(turn), std::sin(turn), 0);
        const dvec3 tangent = glm::normalize(toward - n * glm::dot(n, toward));
        const glm::dmat3 frame(tangent, glm::cross(n, tangent), n);
        double sum = 0;
        for (const dvec3& k : kernel) {
            const dvec3 s = p + frame * k * radius;
            const double z = -depth_at(picture, picture.place(s));
            const double t = std::min(radius / std::abs(p.z - z), 1.0);
            if (z >= s.z) sum += t * t * (3 - 2 * t);
        }
        return 1 - sum / static_cast<double>(kernel.size());
    };
}

Estimator vermeer_hbao(const Picture& picture, const Noise& noise, double radius) {
    constexpr double kBias = std::numbers::pi / 6;
    return [&picture, noise, radius](int x, int y) {
        const dvec3 n = picture.face_normal(x, y);
        const double sum = sum_over_directions(
            picture, noise, radius, x, y, [&](const dvec3& direction, const dvec3(&steps)[kSteps]) {
                double ao = 0;
                double horizon = std::atan(-glm::dot(direction, n) / std::max(n.z, 1e-4)) + kBias;
                for (const dvec3& v : steps) {
                    const double angle = std::atan2(v.z, std::hypot(v.x, v.y));
                    if (glm::dot(v, v) == 0 || angle <= horizon || glm::length(v) >= radius) continue;
                    ao += falloff(v, radius) * (std::sin(angle) - std::sin(horizon));
                    horizon = angle;
                }
                return ao;
            });
        return std::max(0.0, 1 - sum / kDirections);
    };
}

Estimator vermeer_hbao_plus(const Picture& picture, const Noise& noise, double radius) {
    constexpr double kBias = 0.1;
    return [&picture, noise, radius](int x, int y) {
        const dvec3 n = picture.face_normal(x, y);
        const double sum =
            sum_over_directions(picture, noise, radius, x, y, [&](const dvec3&, const dvec3(&steps)[kSteps]) {
                double ao = 0;
                for (const dvec3& v : steps) {
                    const double above = glm::dot(v, n) / std::max(glm::length(v), 1e-30) - kBias;
                    ao += std::max(falloff(v, radius), 0.0) * std::max(above, 0.0);
                }
                return ao;
            });
        return 1 - sum / (kDirections * kSteps);
    };
}

}  // namespace aoscore::testing::published
