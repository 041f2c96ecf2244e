#include "framing/spread_cameras.h"

#include "framing/outline_fit.h"
#include "framing/room_survey.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kSpreadFovy_deg = 60, kLowest_deg = -45, kHighest_deg = 15;
constexpr double kLeastCoverage = 0.4, kMostClose = 0.25, kUsualFronts = 0.5;
constexpr double kSameWay_deg = 45;
constexpr double kClearancePerSight = 0.1, kClosePerSight = 0.2;
constexpr double kApartPerSight = 0.5, kApartPerDiagonal = 0.15;

/// Number i of a sequence that fills the unit cube evenly (Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
glm::dvec3 even_point(std::size_t i) {
    constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
    const auto n = static_cast<double>(i + 1);
    return glm::fract(glm::dvec3(0.5) +
                      n * glm::dvec3(1 / kRoot, 1 / (kRoot * kRoot), 1 / (kRoot * kRoot * kRoot)));
}

glm::dvec3 way_at(double azimuth_rad, double elevation_rad) {
    return {std::sin(azimuth_rad) * std::cos(elevation_rad), std::sin(elevation_rad),
            std::cos(azimuth_rad) * std::cos(elevation_rad)};
}

/// The place at eye level below or above a seat; the seat itself where no floor is below.
glm::dvec3 at_eye_level(const Scout& scout, const glm::dvec3& seat, const std::optional<double>& height_m) {
    if (!height_m) return seat;
    const double down_m = scout.first_surface(seat, {0, -1, 0}).distance_m;
    return std::isfinite(down_m) ? seat + glm::dvec3(0, *height_m - down_m, 0) : seat;
}

/// The seats with room around them, so that none is in a crack; all where none has.
std::vector<Seat> roomy_seats(const RoomSurvey& survey) {
    std::vector<Seat> roomy = survey.seats;
    std::erase_if(roomy, [&](const Seat& s) { return s.clearance_m < kClearancePerSight * survey.sight_m; });
    return roomy.empty() ? survey.seats : roomy;
}

Candidate inside_camera(const Trial& trial, const RoomSurvey& survey, const std::vector<Seat>& seats,
                        std::size_t i, const std::optional<double>& height_m) {
    const glm::dvec3 at = even_point(i);
    const Seat& seat = seats[static_cast<std::size_t>(at.x * static_cast<double>(seats.size()))];
    Camera camera;
    camera.fovy_rad = glm::radians(kSpreadFovy_deg);
    camera.position = at_eye_level(trial.scout, seat.position, height_m);
    camera.target =
        camera.position + survey.sight_m * way_at(2 * std::numbers::pi * at.y,
                                                  glm::radians(glm::mix(kLowest_deg, kHighest_deg, at.z)));
    return {camera, 0, {}};
}

/// Fitted to the outline, or up to three times as near, where it shows a part.
Candidate outside_camera(const Trial& trial, std::size_t i) {
    constexpr double kSpreadMargin = 0.02, kLeast_deg = 3, kMost_deg = 65, kNearest = 1.0 / 3;
    const glm::dvec3 at = even_point(i);
    const glm::dvec3 to_camera =
        way_at(2 * std::numbers::pi * at.x, glm::radians(glm::mix(kLeast_deg, kMost_deg, at.y)));
    Camera camera = fit_outline(trial.main.outline, -to_camera, {0, 1, 0}, glm::radians(kSpreadFovy_deg),
                                trial.aspect, kSpreadMargin);
    const glm::dvec3 centre = (trial.main.bounds.low + trial.main.bounds.high) / 2.0;
    const double part = glm::mix(kNearest, 1.0, at.z);
    camera.position = centre + (camera.position - centre) * part;
    camera.target = camera.position - to_camera * trial.main.bounds.diagonal();
    return {camera, 0, {}};
}

double share_of(const Glance& glance, auto condition) {
    const auto count = std::ranges::count_if(glance.points, condition);
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(glance.points.size(), 1));
}

double fronts_of(const Candidate& candidate) {
    return share_of(candidate.glance, [](const Glance::Point& p) { return p.front; });
}

/// The median share of fronts: files may have all of their triangles wound the wrong way round.
double usual_fronts(const std::vector<Candidate>& candidates) {
    std::vector<double> shares;
    for (const Candidate& candidate : candidates) shares.push_back(fronts_of(candidate));
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    return *middle;
}

/// Tries the cameras, and keeps those whose pictures can be judged.
void keep_judged(const Trial& trial, double close_m, std::vector<Candidate>& cameras) {
    try_cameras(trial, close_m, cameras);
    const double least_fronts = kUsualFronts * usual_fronts(cameras);
    std::erase_if(cameras, [&](const Candidate& c) {
        const double close = share_of(c.glance, [&](const Glance::Point& p) { return p.depth_m < close_m; });
        return c.glance.coverage() < kLeastCoverage || fronts_of(c) < least_fronts || close > kMostClose;
    });
}

SpreadCameras spread_inside(const Trial& trial, const RoomSurvey& survey, std::size_t count,
                            const std::optional<double>& height_m) {
    SpreadCameras spread{{}, count, kApartPerSight * survey.sight_m, true};
    const std::vector<Seat> seats = roomy_seats(survey);
    for (std::size_t i = 0; i < count; ++i)
        spread.cameras.push_back(inside_camera(trial, survey, seats, i, height_m));
    keep_judged(trial, std::max(kClosePerSight * survey.sight_m, trial.radius_m), spread.cameras);
    return spread;
}

SpreadCameras spread_outside(const Trial& trial, std::size_t count) {
    SpreadCameras spread{{}, count, kApartPerDiagonal * trial.main.bounds.diagonal(), false};
    for (std::size_t i = 0; i < count; ++i) spread.cameras.push_back(outside_camera(trial, i));
    keep_judged(trial, 0, spread.cameras);
    return spread;
}

}  // namespace

SpreadCameras spread_cameras(const Trial& trial, std::size_t count, std::optional<double> height_m) {
    const RoomSurvey survey = survey_rooms(trial.scout, trial.main.bounds);
    if (has_rooms(survey, trial.main.bounds) && !survey.seats.empty()) {
        SpreadCameras inside = spread_inside(trial, survey, count, height_m);
        if (!inside.cameras.empty() || height_m) return inside;
    }
    return spread_outside(trial, count);
}

Error no_camera_to_judge(const SpreadCameras& spread, const std::string& scene_id) {
    return Error(
        ExitCode::gate_failed,
        fmt::format("none of the {} cameras that were tried can be judged: on every picture surfaces "
                    "cover less than {:.0f} %, or most are too near or show their backs",
                    spread.tried, 100 * kLeastCoverage),
        scene_id, "another --height, --unit or --up, or a scene with room for a camera");
}

bool are_neighbours(const Camera& a, const Camera& b, double apart_m) {
    const glm::dvec3 way_a = glm::normalize(a.target - a.position),
                     way_b = glm::normalize(b.target - b.position);
    return glm::distance(a.position, b.position) < apart_m &&
           glm::dot(way_a, way_b) > std::cos(glm::radians(kSameWay_deg));
}

std::vector<Candidate> distinct_cameras(const SpreadCameras& spread, std::size_t most) {
    std::vector<Candidate> sorted = spread.cameras, chosen;
    std::ranges::stable_sort(sorted, std::ranges::greater(), &Candidate::worth);
    for (const Candidate& candidate : sorted) {
        if (chosen.size() == most) break;
        const bool apart = std::ranges::none_of(chosen, [&](const Candidate& other) {
            return are_neighbours(candidate.camera, other.camera, spread.apart_m);
        });
        if (apart) chosen.push_back(candidate);
    }
    return chosen;
}

}  // namespace aoscore
