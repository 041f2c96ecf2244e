#include "framing/room_survey.h"

#include "core/threads.h"
#include "framing/spread_direction.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr std::size_t kPlaces = 400;
constexpr int kSurveyRays = 40;
constexpr double kRoomFronts = 0.7, kHollowHits = 0.95, kHollowFronts = 0.2, kSolidFronts = 0.05;
constexpr double kEyeHeight = 1.0 / 3;  // of the room's height
/// Limits for the share of air in rooms, the share of places in hollows, and the median sight as a share of
/// the diagonal.
constexpr double kMostlyRooms = 0.5, kPartlyRooms = 0.15, kPartlyHollow = 0.15, kRoomySight = 0.06;
/// A place lies in a surface where surfaces all around are nearer than this share of the box's diagonal, as
/// all places of a flat scene do.
constexpr double kLeastSight = 1e-6;

struct Surroundings {
    double hits = 0, fronts = 0;  // as shares of the rays
    double nearest_m = 0, median_m = 0;
};

Surroundings look_around(const Scout& scout, const glm::dvec3& from) {
    Surroundings around;
    std::vector<double> distances;
    for (int i = 0; i < kSurveyRays; ++i) {
        const Sight sight = scout.first_surface(from, spread_direction({0, 1, 0}, -1, i, kSurveyRays));
        around.hits += std::isfinite(sight.distance_m) / static_cast<double>(kSurveyRays);
        around.fronts += sight.front / static_cast<double>(kSurveyRays);
        distances.push_back(sight.distance_m);
    }
    std::ranges::sort(distances);
    around.nearest_m = distances.front();
    around.median_m = distances[distances.size() / 2];
    return around;
}

glm::dvec3 place(const Bounds& box, std::size_t i) {
    // The steps are powers of the inverse of the root of x^4 = x + 1.
    constexpr double kRoot = 1.2207440846057596;
    const double a = 1 / kRoot, n = static_cast<double>(i + 1);
    const glm::dvec3 at(n * a, n * a * a, n * a * a * a);
    return box.low + glm::fract(at) * (box.high - box.low);
}

enum class Kind { outdoors, room, hollow, solid };

Kind kind_of(const Surroundings& around) {
    if (around.fronts >= kRoomFronts) return Kind::room;
    if (around.hits >= kHollowHits) {
        if (around.fronts >= kHollowFronts) return Kind::hollow;
        if (around.fronts <= kSolidFronts) return Kind::solid;
    }
    return Kind::outdoors;
}

/// Moves a place up or down its column of air to the height of a person's eyes.
glm::dvec3 at_eye_height(const Scout& scout, const glm::dvec3& from) {
    const double up = scout.first_surface(from, {0, 1, 0}).distance_m;
    const double down = scout.first_surface(from, {0, -1, 0}).distance_m;
    if (!std::isfinite(down)) return from;
    const double height = std::isfinite(up) ? up + down : 2 * down;
    return from + glm::dvec3(0, kEyeHeight * height - down, 0);
}

struct Place {
    Kind kind = Kind::outdoors;
    Seat seat;
};

Place ask(const Scout& scout, const glm::dvec3& at, double least_sight_m) {
    const Surroundings first = look_around(scout, at);
    if (first.median_m <= least_sight_m) return {};
    Place found{kind_of(first), {}};
    if (found.kind != Kind::room && found.kind != Kind::hollow) return found;
    found.seat.position = at_eye_height(scout, at);
    const Surroundings around = look_around(scout, found.seat.position);
    found.seat.clearance_m = around.nearest_m;
    found.seat.sight_m = around.median_m;
    return found;
}

}  // namespace

RoomSurvey survey_rooms(const Scout& scout, const Bounds& box) {
    std::vector<Place> places(kPlaces);
    const double least_sight_m = kLeastSight * box.diagonal();
    parallel_for(kPlaces, [&](std::size_t i) { places[i] = ask(scout, place(box, i), least_sight_m); });
    const auto count = [&](Kind kind) {
        return static_cast<double>(std::ranges::count(places, kind, &Place::kind));
    };
    RoomSurvey survey;
    const double air = static_cast<double>(kPlaces) - count(Kind::solid);
    survey.rooms = air > 0 ? count(Kind::room) / air : 0;
    survey.hollows = count(Kind::hollow) / static_cast<double>(kPlaces);
    const Kind wanted = count(Kind::room) > 0 ? Kind::room : Kind::hollow;
    for (const Place& p : places) {
        if (p.kind == wanted && std::isfinite(p.seat.sight_m)) survey.seats.push_back(p.seat);
    }
    std::ranges::stable_sort(survey.seats, std::ranges::greater(), &Seat::sight_m);
    if (!survey.seats.empty()) survey.sight_m = survey.seats[survey.seats.size() / 2].sight_m;
    return survey;
}

bool has_rooms(const RoomSurvey& survey, const Bounds& box) {
    if (survey.rooms >= kMostlyRooms) return true;
    return (survey.rooms >= kPartlyRooms || survey.hollows >= kPartlyHollow) &&
           survey.sight_m >= kRoomySight * box.diagonal();
}

}  // namespace aoscore
