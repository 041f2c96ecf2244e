#pragma once

#include "framing/candidate.h"
#include "framing/room_survey.h"

#include <vector>

namespace aoscore {

/// Views from seats in a scene's rooms: of several seats, apart from each other and from the walls, and
/// directions a little downwards, those whose pictures are worth most; each next one is far from those before
/// or looks elsewhere. None where the survey found no seat.
std::vector<Candidate> inside_cameras(const Trial& trial, const RoomSurvey& survey, std::size_t count);

}  // namespace aoscore
