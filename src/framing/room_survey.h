#pragma once

#include "reference/tracer/scout.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// A place in the air of a room where somebody could stand, at a third of the room's height there.
struct Seat {
    glm::dvec3 position{0};
    double clearance_m = 0;  ///< to the nearest surface, of the rays that were sent
    double sight_m = 0;      ///< median distance of what the rays meet
};

/// What a box around a scene's main part holds.
struct RoomSurvey {
    double rooms = 0;         ///< share of its air that lies in rooms: most rays meet the front of something
    double hollows = 0;       ///< share of its places where all rays meet something, fronts and backs
    std::vector<Seat> seats;  ///< in rooms, or where there are none in hollows; those with most room first
    double sight_m = 0;       ///< median of the seats' sights
};

/// Asks places all over the box, as evenly spread as the R3 sequence is (Roberts, The Unreasonable
/// Effectiveness of Quasirandom Sequences, 2018), by rays in all directions. A place is in a room where 7 in
/// 10 rays meet a front first; within a solid thing where hardly any does; in a hollow, such as a room whose
/// walls are wound the wrong way round or a housing with things in it, where nearly all meet something and
/// one in five a front; outdoors else.
RoomSurvey survey_rooms(const Scout& scout, const Bounds& box);

}  // namespace aoscore
