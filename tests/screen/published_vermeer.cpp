// Vermeer, Stochastic-Depth Ambient Occlusion, 2020: algorithms 1 to 3 over one depth a texel, 7 to 9 over
// the depths of a stochastic-depth buffer; normals from differences of depth.
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

using Points = std::vector<dvec3>;

// The depths at a place, and the background's outside of the picture.
std::vector<double> depths_at(const Picture& picture, const dvec2& place) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    const bool inside = x >= 0 && y >= 0 && x < picture.width() && y < picture.height();
    return inside ? picture.depths(x, y) : std::vector<double>{picture.far()};
}

// The surfaces' points in the texel of a place.
Points surfaces_at(const Picture& picture, const dvec2& place) {
    Points points;
    for (const double depth : depths_at(picture, place))
        points.push_back(picture.point(std::floor(place.x) + 0.5, std::floor(place.y) + 0.5, depth));
    return points;
}

// Sums `along` over the marched directions; it gets the direction in view space and, for each step, the
// vectors from the pixel to all surfaces of its texel.
double sum_over_directions(
    const Picture& picture, const Noise& noise, double radius, int x, int y,
    const std::function<double(const dvec3& direction, const Points (&steps)[kSteps])>& along) {
    const dvec3 p = picture.point(x, y);
    const glm::dvec4 xi = noise(x, y);
    const double step = radius * picture.pixels_per_metre(-p.z) / (kSteps + 1);
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = (i + xi.x) * 2 * std::numbers::pi / kDirections;
        const dvec2 d(std::cos(angle), std::sin(angle));
        Points steps[kSteps];
        for (int j = 0; j < kSteps; ++j) {
            steps[j] = surfaces_at(picture, dvec2(x + 0.5, y + 0.5) + d * ((j + 1 + xi.y) * step));
            for (dvec3& v : steps[j]) v -= p;
        }
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
            double most = 0;
            for (const double depth : depths_at(picture, picture.place(s))) {
                const double t = std::min(radius / std::abs(p.z + depth), 1.0);
                if (-depth >= s.z) most = std::max(most, t * t * (3 - 2 * t));
            }
            sum += most;
        }
        return 1 - sum / static_cast<double>(kernel.size());
    };
}

Estimator vermeer_hbao(const Picture& picture, const Noise& noise, double radius, double least_cosine) {
    constexpr double kBias = std::numbers::pi / 6;
    return [&picture, noise, radius, least_cosine](int x, int y) {
        const dvec3 n = picture.face_normal(x, y);
        const double sum = sum_over_directions(
            picture, noise, radius, x, y, [&](const dvec3& direction, const Points(&steps)[kSteps]) {
                double ao = 0;
                double horizon = std::atan(-glm::dot(direction, n) / std::max(n.z, 1e-4)) + kBias;
                for (const Points& step : steps) {
                    double most = 0, highest = horizon;
                    for (const dvec3& v : step) {
                        const double angle = std::atan2(v.z, std::hypot(v.x, v.y));
                        if (glm::dot(v, v) == 0 || angle <= horizon || glm::length(v) >= radius) continue;
                        if (glm::dot(v, n) <= least_cosine * glm::length(v)) continue;
                        const double adds = falloff(v, radius) * (std::sin(angle) - std::sin(horizon));
                        if (adds > most) highest = angle;
                        most = std::max(most, adds);
                    }
                    ao += most;
                    horizon = highest;
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
        const double sum = sum_over_directions(
            picture, noise, radius, x, y, [&](const dvec3&, const Points(&steps)[kSteps]) {
                double ao = 0;
                for (const Points& step : steps) {
                    double most = 0;
                    for (const dvec3& v : step) {
                        const double above = glm::dot(v, n) / std::max(glm::length(v), 1e-30) - kBias;
                        most = std::max(most, std::max(falloff(v, radius), 0.0) * std::max(above, 0.0));
                    }
                    ao += most;
                }
                return ao;
            });
        return 1 - sum / (kDirections * kSteps);
    };
}

}  // namespace aoscore::testing::published
