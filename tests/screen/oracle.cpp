#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::oracle {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

glm::dmat3 basis(const glm::dvec3& n) {
    const glm::dvec3 other = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 t = glm::normalize(glm::cross(other, n));
    return {t, glm::cross(n, t), n};
}

double unit(Random& random) {
    return std::uniform_real_distribution<double>(0, 1)(random);
}

glm::dvec3 sphere_direction(Random& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

glm::dvec3 cube_direction(Random& random) {
    return glm::normalize(glm::dvec3(2 * unit(random) - 1, 2 * unit(random) - 1, 2 * unit(random) - 1));
}

glm::dvec3 hemisphere_direction(Random& random) {
    glm::dvec3 d = sphere_direction(random);
    d.z = std::abs(d.z);
    return d;
}

glm::dvec3 cosine_direction(Random& random) {
    const glm::dvec2 p = disc_point(random);
    return {p, std::sqrt(std::max(0.0, 1 - glm::dot(p, p)))};
}

glm::dvec2 disc_point(Random& random) {
    for (;;) {
        const glm::dvec2 p(2 * unit(random) - 1, 2 * unit(random) - 1);
        if (glm::dot(p, p) <= 1) return p;
    }
}

double mean(int count, const std::function<double(Random&)>& value) {
    Random random(20221);
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += value(random);
    return sum / count;
}

double disc_mean(const Field& field, const Point& point, double radius,
                 const std::function<double(const glm::dvec3& v)>& value) {
    constexpr int kCells = 400;
    double sum = 0, count = 0;
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            const glm::dvec2 offset((2 * (i + 0.5) / kCells - 1) * radius,
                                    (2 * (j + 0.5) / kCells - 1) * radius);
            if (glm::length(offset) > radius) continue;
            sum += value(surface(field, point.p.x + offset.x, point.p.y + offset.y) - point.p);
            ++count;
        }
    }
    return sum / count;
}

bool hidden(const Field& field, const glm::dvec3& s, double bias) {
    return field.z(s.x, s.y) >= s.z + bias;
}

Slice slice(const Field& field, const Point& point, double azimuth, double radius,
            const std::function<double(double)>& weight) {
    const glm::dvec3 along(std::cos(azimuth), std::sin(azimuth), 0), view(0, 0, 1);
    Slice result;
    const glm::dvec2 projected(glm::dot(point.n, along), glm::dot(point.n, view));
    result.normal_length = glm::length(projected);
    result.gamma = std::atan2(projected.x, projected.y);
    for (const double side : {-1.0, 1.0}) {
        const double open = std::cos(result.gamma + side * kPi / 2);
        double horizon = open;
        constexpr int kSteps = 300;
        for (int i = 1; i <= kSteps; ++i) {
            // The march begins after one footprint, as in a depth buffer.
            const double t = field.footprint + (radius - field.footprint) * i / kSteps;
            const glm::dvec3 v =
                surface(field, point.p.x + side * t * along.x, point.p.y + side * t * along.y) - point.p;
            horizon = std::max(horizon, std::lerp(open, v.z / glm::length(v), weight(glm::length(v))));
        }
        (side < 0 ? result.h0 : result.h1) = side * std::acos(std::clamp(horizon, -1.0, 1.0));
    }
    result.h0 = std::max(result.h0, result.gamma - kPi / 2);
    result.h1 = std::min(result.h1, result.gamma + kPi / 2);
    return result;
}

double slice_visibility(const Slice& s) {
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = s.h0 + (s.h1 - s.h0) * (i + 0.5) / kSteps;
        sum += std::max(std::cos(t - s.gamma), 0.0) * std::abs(std::sin(t));
    }
    return s.normal_length * sum * (s.h1 - s.h0) / kSteps;
}

}  // namespace aoscore::testing::oracle
