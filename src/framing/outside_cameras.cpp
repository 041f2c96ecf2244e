#include "framing/outside_cameras.h"

#include "framing/outline_fit.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kOutsideFovy_deg = 45;
constexpr double kMargin = 0.04;
constexpr double kAzimuths_deg[] = {35, -35, 55, -55, 125, -125, 145, -145};  // from +z to +x
constexpr double kElevations_deg[] = {20, 35, 50};
constexpr double kStraightAzimuths_deg[] = {0, 90, 180, -90}, kStraightElevation_deg = 5;
/// Factors on the worth of a view from behind, or from high above, against one from the front.
constexpr double kBehind = 0.85, kAbove = 0.9;
constexpr double kOtherSide_deg = 80;

struct Direction {
    double azimuth_deg = 0;
    glm::dvec3 to_camera{0};
    double preference = 1;
};

Direction direction_at(double azimuth_deg, double elevation_deg) {
    const double azimuth = glm::radians(azimuth_deg), elevation = glm::radians(elevation_deg);
    Direction direction{azimuth_deg,
                        {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                         std::cos(azimuth) * std::cos(elevation)}};
    if (std::abs(azimuth_deg) > 90) direction.preference *= kBehind;
    if (elevation_deg > kElevations_deg[1]) direction.preference *= kAbove;
    return direction;
}

std::vector<Direction> directions(Around around) {
    std::vector<Direction> all;
    for (const double elevation_deg : kElevations_deg) {
        for (const double azimuth_deg : kAzimuths_deg)
            all.push_back(direction_at(azimuth_deg, elevation_deg));
    }
    if (around == Around::straight_too) {
        for (const double azimuth_deg : kStraightAzimuths_deg)
            all.push_back(direction_at(azimuth_deg, kStraightElevation_deg));
    }
    return all;
}

/// The outline of the main part; a mere point gets room around it, so that a camera exists.
std::vector<glm::dvec3> with_extent(const MainPart& main) {
    std::vector<glm::dvec3> points = main.outline;
    if (main.bounds.diagonal() > 0) return points;
    const double room = std::max(1e-3, 1e-3 * glm::length(points.front()));
    points.push_back(points.front() + room);
    points.push_back(points.front() - room);
    return points;
}

double degrees_between(double a, double b) {
    const double apart = std::abs(a - b);
    return std::min(apart, 360 - apart);
}

}  // namespace

std::vector<Candidate> outside_cameras(const Trial& trial, Around around, std::size_t count) {
    std::vector<Direction> left = directions(around);
    const std::vector<glm::dvec3> points = with_extent(trial.main);
    std::vector<Candidate> candidates;
    for (const Direction& d : left) {
        candidates.push_back(
            {fit_outline(points, -d.to_camera, {0, 1, 0}, glm::radians(kOutsideFovy_deg), trial.aspect, kMargin),
             0,
             {}});
    }
    try_cameras(trial, 0, candidates);
    for (std::size_t i = 0; i < left.size(); ++i) candidates[i].worth *= left[i].preference;
    std::vector<Candidate> chosen;
    while (chosen.size() < count && !candidates.empty()) {
        const auto best = static_cast<std::size_t>(&best_of(candidates) - candidates.data());
        const double azimuth_deg = left[best].azimuth_deg;
        chosen.push_back(candidates[best]);
        for (std::size_t i = candidates.size(); i-- > 0;) {
            if (degrees_between(left[i].azimuth_deg, azimuth_deg) >= kOtherSide_deg) continue;
            candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(i));
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return chosen;
}

}  // namespace aoscore
