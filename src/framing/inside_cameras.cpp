#include "framing/inside_cameras.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

constexpr double kFovy_deg = 60;
constexpr double kPitch_deg = -6;
constexpr std::size_t kSeats = 16;
constexpr int kAzimuths = 6;
/// The clearance of a seat, the distance between seats, and the distance that counts as close in a picture,
/// as shares of the median sight of all seats.
constexpr double kClearance = 0.1, kApart = 0.6, kClose = 0.2;
/// A further view is at least so many median sights away, or turned by so much.
constexpr double kOtherSeat = 1.5, kOtherWay_deg = 75;
/// A view worth less than this share of the first one is left out.
constexpr double kWorthwhile = 0.6;

std::vector<Seat> seats_apart(const RoomSurvey& survey) {
    std::vector<Seat> chosen;
    for (const Seat& seat : survey.seats) {
        if (chosen.size() == kSeats) break;
        if (seat.clearance_m < kClearance * survey.sight_m) continue;
        const bool is_apart = std::ranges::all_of(chosen, [&](const Seat& other) {
            return glm::distance(other.position, seat.position) >= kApart * survey.sight_m;
        });
        if (is_apart) chosen.push_back(seat);
    }
    if (chosen.empty() && !survey.seats.empty()) chosen.push_back(survey.seats.front());
    return chosen;
}

/// How much of a room a picture shows: 1 where its median depth is that of all sights and a tenth of it is at
/// least four times as far as another tenth; less where a wall fills it, or a parapet stands before the
/// camera.
double room_shown(const Glance& glance, double sight_m) {
    constexpr double kWall = 0.3, kDeep = 4;
    if (glance.points.empty()) return 0;
    std::vector<double> depths;
    for (const Glance::Point& p : glance.points) depths.push_back(p.depth_m);
    std::ranges::sort(depths);
    const double ratio = depths[depths.size() * 9 / 10] / depths[depths.size() / 10];
    const double depth = kWall + (1 - kWall) * std::log(ratio) / std::log(kDeep);
    return std::min(1.0, depth) * std::min(1.0, depths[depths.size() / 2] / sight_m);
}

bool is_another(const Candidate& a, const Candidate& b, double sight_m) {
    const glm::dvec3 way_a = glm::normalize(a.camera.target - a.camera.position);
    const glm::dvec3 way_b = glm::normalize(b.camera.target - b.camera.position);
    return glm::distance(a.camera.position, b.camera.position) >= kOtherSeat * sight_m ||
           glm::dot(way_a, way_b) <= std::cos(glm::radians(kOtherWay_deg));
}

}  // namespace

std::vector<Candidate> inside_cameras(const Trial& trial, const RoomSurvey& survey, std::size_t count) {
    std::vector<Candidate> candidates;
    const double pitch = glm::radians(kPitch_deg);
    for (const Seat& seat : seats_apart(survey)) {
        for (int i = 0; i < kAzimuths; ++i) {
            // Directions are turned a little, so that walls along the axes are not seen at right angles.
            const double azimuth = glm::radians(360.0 * (i + 0.25) / kAzimuths);
            Camera camera;
            camera.fovy_rad = glm::radians(kFovy_deg);
            camera.position = seat.position;
            camera.target = seat.position + survey.sight_m * glm::dvec3(std::sin(azimuth) * std::cos(pitch),
                                                                        std::sin(pitch),
                                                                        std::cos(azimuth) * std::cos(pitch));
            candidates.push_back({camera, 0, {}});
        }
    }
    try_cameras(trial, kClose * survey.sight_m, candidates);
    for (Candidate& candidate : candidates) candidate.worth *= room_shown(candidate.glance, survey.sight_m);
    std::vector<Candidate> chosen;
    while (chosen.size() < count && !candidates.empty()) {
        const Candidate& best = best_of(candidates);
        if (!chosen.empty() && best.worth < kWorthwhile * chosen.front().worth) break;
        chosen.push_back(best);
        std::erase_if(candidates,
                      [&](const Candidate& c) { return !is_another(c, chosen.back(), survey.sight_m); });
    }
    return chosen;
}

}  // namespace aoscore
