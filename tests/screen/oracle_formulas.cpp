#include "oracle_formulas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::formula {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;

// The mean of a march's contributions over dense directions and steps.
double march(const std::function<double(double azimuth, double shift)>& direction) {
    double sum = 0;
    constexpr int kDirections = 180, kShifts = 4;
    for (int i = 0; i < kDirections; ++i) {
        for (int j = 0; j < kShifts; ++j) sum += direction(2 * kPi * i / kDirections, (j + 0.5) / kShifts);
    }
    return sum / (kDirections * kShifts);
}

double slices(const std::function<double(double azimuth)>& value) {
    constexpr int kSlices = 90;
    double sum = 0;
    for (int i = 0; i < kSlices; ++i) sum += value(kPi * (i + 0.5) / kSlices);
    return sum / kSlices;
}

}  // namespace

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// V = 1 - the mean occlusion at points P + frame · draw() · R.
double point_test(const Field& field, const Point& point, const std::function<dvec3(Random&)>& draw,
                  const std::function<double(const dvec3& offset, double surface_z)>& weight, double bias) {
    const glm::dmat3 frame = oracle::basis(point.n);
    return 1 - oracle::mean(60000, [&](Random& random) {
               const dvec3 offset = draw(random);
               const dvec3 s = point.p + frame * offset * kRadius;
               return oracle::hidden(field, s, bias) ? weight(offset, field.z(s.x, s.y)) : 0.0;
           });
}
double always(const dvec3&, double) {
    return 1;
}

// Scales a direction by a random distance, so that the points fill the ball evenly.
dvec3 in_volume(const dvec3& direction, Random& random) {
    return direction * std::cbrt(oracle::unit(random));
}

double alchemy(const Field& field, const Point& point, double sigma, double kappa) {
    const double mean = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        return std::max(0.0, glm::dot(v, point.n) + point.p.z * 0.001) / (glm::dot(v, v) + 1e-4);
    });
    return std::pow(std::max(0.0, 1 - 2 * sigma * mean), kappa);
}

double sao(const Field& field, const Point& point) {
    // The spiral's taps are even in radius, not in the disc's area: their weight is 1/r.
    double weights = 0;
    const double sum = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const double r = std::max(glm::length(dvec2(v)), 1e-4), d2 = glm::dot(v, v);
        weights += 1 / r;
        return std::pow(std::max(kRadius * kRadius - d2, 0.0), 3) *
               std::max((glm::dot(v, point.n) - 0.01) / (d2 + 0.01), 0.0) / r;
    });
    const double count = 400 * 400 * kPi / 4;
    return std::max(0.0, 1 - 5 * 0.1 / std::pow(kRadius, 6) * sum / (weights / count));
}

double cacao(const Field& field, const Point& point) {
    double weights = 0;
    const double sum = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const double d2 = glm::dot(v, v),
                     weight = 0.4 + 0.6 * std::clamp(2 - std::max(v.z, 0.0) / kRadius, 0.0, 1.0);
        weights += weight;
        return weight * std::max(0.0, glm::dot(v, point.n) / std::sqrt(d2) - 0.06) *
               std::max(0.0, 1 - d2 / (kRadius * kRadius));
    });
    const double count = 400 * 400 * kPi / 4;
    return std::pow(1 - std::min(4.3 * sum / (weights / count), 0.98), 1.5);
}

double sphere_caps(const Field& field, const Point& point) {
    const double pixels = kPi * std::pow(kRadius / kPixel, 2);
    return std::max(0.0, 1 - pixels / kPi * oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
                                 const double d = glm::length(v), r = kPixel / 2;
                                 if (d > kRadius || r >= d) return 0.0;
                                 return 2 * kPi * (1 - std::cos(std::asin(r / d))) *
                                        std::max(glm::dot(v, point.n) / d, 0.0);
                             }));
}

// Open lengths of lines along the axis, z toward the viewer, unit sphere at the origin.
double volumetric(const Field& field, const Point& point, bool hemisphere) {
    double whole = 0;
    const double open = oracle::disc_mean(field, point, kRadius, [&](const dvec3& v) {
        const dvec3 u = v / kRadius;
        const double front = std::sqrt(std::max(0.0, 1 - u.x * u.x - u.y * u.y));
        const double tangent = -(point.n.x * u.x + point.n.y * u.y) / point.n.z;
        const double low = hemisphere ? std::clamp(tangent, -front, front) : -front;
        whole += hemisphere ? front - low : front;
        return std::max(front - std::max(u.z, low), 0.0);
    });
    return std::min(1.0, open / (whole / (400 * 400 * kPi / 4)));
}

double tangent_sphere(const Field& field, const Point& point) {
    const dvec3 centre = point.p + point.n * kRadius / 2.0;
    double whole = 0;
    const Point at_centre{centre, point.n};
    const double open = oracle::disc_mean(field, at_centre, kRadius / 2, [&](const dvec3& v) {
        const dvec3 u = v / (kRadius / 2);
        const double front = std::sqrt(std::max(0.0, 1 - u.x * u.x - u.y * u.y));
        whole += 2 * front;
        return std::clamp(front - u.z, 0.0, 2 * front);
    });
    return open / (whole / (400 * 400 * kPi / 4));
}

// Adds increments of the horizon over 32 steps.
double hbao(const Field& field, const Point& point, double bias) {
    constexpr int kSteps = 32;
    return 1 - march([&](double azimuth, double shift) {
               const dvec2 d(std::cos(azimuth), std::sin(azimuth));
               const double slope = -glm::dot(dvec2(point.n), d) / point.n.z;
               double horizon = std::min(std::atan(slope) + bias, kPi / 2), occlusion = 0;
               for (int j = 0; j < kSteps; ++j) {
                   const dvec2 at = d * ((j + 1 + shift) * kRadius / (kSteps + 1));
                   const dvec3 v = oracle::surface(field, point.p.x + at.x, point.p.y + at.y) - point.p;
                   const double elevation = std::asin(v.z / glm::length(v)), distance = glm::length(v);
                   if (distance >= kRadius || elevation <= horizon) continue;
                   occlusion +=
                       (1 - std::pow(distance / kRadius, 2)) * (std::sin(elevation) - std::sin(horizon));
                   horizon = elevation;
               }
               return occlusion;
           });
}

// Attenuates once, at the last sample in range; t = acos(D·n) - π/2 + bias; steps of `step` metres.
double hbao_hussain(const Field& field, const Point& point, double step, int steps) {
    return march([&](double azimuth, double) {
        const dvec2 d(std::cos(azimuth), std::sin(azimuth));
        const double tangent = std::acos(glm::dot(dvec2(point.n), d)) - kPi / 2 + 0.3;
        double horizon = tangent, last = 0;
        for (int j = 1; j <= steps; ++j) {
            const dvec2 at = d * (step * j);
            const dvec3 v = oracle::surface(field, point.p.x + at.x, point.p.y + at.y) - point.p;
            if (glm::length(v) >= kRadius) continue;
            last = glm::length(v);
            horizon = std::max(horizon, std::atan(v.z / glm::length(dvec2(v))));
        }
        return 1 - std::clamp((1 - std::pow(last / kRadius, 2)) * (std::sin(horizon) - std::sin(tangent)),
                              0.0, 1.0);
    });
}

double hbao_plus(const Field& field, const Point& point) {
    constexpr int kSteps = 32;
    return 1 - march([&](double azimuth, double shift) {
               double sum = 0;
               for (int j = 0; j < kSteps; ++j) {
                   const double t = (j + 1 + shift) * kRadius / (kSteps + 1);
                   const dvec3 v = oracle::surface(field, point.p.x + t * std::cos(azimuth),
                                                   point.p.y + t * std::sin(azimuth)) -
                                   point.p;
                   const double d = glm::length(v);
                   sum += std::max(1 - std::pow(d / kRadius, 2), 0.0) *
                          std::max(glm::dot(v, point.n) / d - 0.1, 0.0);
               }
               return sum / kSteps;
           });
}

double gtao(const Field& field, const Point& point) {
    return slices([&](double azimuth) {
        return oracle::slice_visibility(
            oracle::slice(field, point, azimuth, kRadius, [](double d) { return d < kRadius ? 1.0 : 0.0; }));
    });
}

double xegtao(const Field& field, const Point& point) {
    const double radius = kRadius * 1.457;
    const double open = slices([&](double azimuth) {
        auto s = oracle::slice(field, point, azimuth, radius, [&](double d) {
            return std::clamp((radius - d) / (0.615 * radius), 0.0, 1.0);
        });
        const double whole = s.normal_length;
        return oracle::slice_visibility(s) / whole * std::lerp(whole, 1.0, 0.05);
    });
    return std::max(0.03, std::pow(std::min(open, 1.0), 2.2));
}

// For solid surfaces a slice is open between its horizons.
double uniform_sectors(const Field& field, const Point& point) {
    return slices([&](double azimuth) {
        const auto s =
            oracle::slice(field, point, azimuth, kRadius, [](double d) { return d < kRadius ? 1.0 : 0.0; });
        return (s.h1 - s.h0) / kPi;
    });
}

double ray_march(const Field& field, const Point& point) {
    const glm::dmat3 frame = oracle::basis(point.n);
    return oracle::mean(6000, [&](Random& random) {
        const dvec3 direction = frame * oracle::cosine_direction(random);
        for (int i = 1; i <= 100; ++i) {
            const dvec3 s = point.p + direction * (kRadius * i / 100);
            // The first steps may lie within rounding of the surface itself.
            if (field.z(s.x, s.y) > s.z + 1e-6) return 0.0;
        }
        return 1.0;
    });
}

}  // namespace aoscore::testing::formula
