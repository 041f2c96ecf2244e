#pragma once

#include "reference/tracer/scout.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// A place in the air of a room where somebody could stand, at a third of the room's height there.
struct Seat {
    glm::dvec3 position{0};
    double clearance_m = 0;  ///< distance to the nearest surface that a ray met
    double sight_m = 0;      ///< median length of the rays
};

/// The rooms in a box around a scene's main part.
struct RoomSurvey {
    double rooms = 0;         ///< share of the air that lies in rooms
    double hollows = 0;       ///< share of places in hollows
    std::vector<Seat> seats;  ///< in rooms, else in hollows; those with most room first
    double sight_m = 0;       ///< median of the seats' sights
};

/// Sends rays in all directions from places in the box, spread evenly by the R3 sequence (Roberts, The
/// Unreasonable Effectiveness of Quasirandom Sequences, 2018). A place is in a room where 7 in 10 rays meet a
/// front first; within a solid where hardly any does; in a hollow, such as a room whose walls are wound the
/// wrong way round or a housing with parts in it, where nearly all meet a surface and one in five a front;
/// and outdoors otherwise.
RoomSurvey survey_rooms(const Scout& scout, const Bounds& box);

/// Whether the box holds a building rather than an object: a building is mostly rooms, however small each is;
/// cavities in an object, such as between the parts of an engine or beside a board on a floor, are few or
/// narrow.
bool has_rooms(const RoomSurvey& survey, const Bounds& box);

}  // namespace aoscore
