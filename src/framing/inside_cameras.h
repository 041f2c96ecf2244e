#pragma once

#include "framing/candidate.h"
#include "framing/room_survey.h"

#include <vector>

namespace aoscore {

/// Finds views from seats in a scene's rooms. It tries several seats, apart from each other and from the
/// walls, in directions a little downwards, and takes the pictures worth most; each further view is far from
/// those before or looks elsewhere. Returns none where the survey found no seat.
std::vector<Candidate> inside_cameras(const Trial& trial, const RoomSurvey& survey, std::size_t count);

}  // namespace aoscore
