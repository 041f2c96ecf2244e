#pragma once

#include "core/error.h"
#include "framing/candidate.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Cameras all over a scene, for a search among them.
struct SpreadCameras {
    std::vector<Candidate> cameras;  ///< those whose pictures can be judged
    std::size_t tried = 0;
    double apart_m = 0;   ///< cameras nearer to each other than this, which look the same way, are neighbours
    bool inside = false;  ///< they stand in rooms
};

/// Tries `count` cameras spread evenly: from seats with room around them in the scene's rooms (see
/// survey_rooms()), in all directions, a little upwards to steeply downwards; or, in a scene without rooms
/// (see has_rooms()) or none that can be judged from its seats, from outside, near and far. `height_m` puts
/// those in rooms at eye level above their floor. A picture can be judged where surfaces cover at least 40 %
/// of it, as many of them show their front as is usual in this scene, and, in rooms, no more than a quarter
/// of them are nearer than a fifth of the median sight: the others stand in or against something. It is
/// deterministic.
SpreadCameras spread_cameras(const Trial& trial, std::size_t count, std::optional<double> height_m);

/// The error of a scene none of whose cameras can be judged: gate_failed.
Error no_camera_to_judge(const SpreadCameras& spread, const std::string& scene_id);

/// Whether two cameras stand nearer to each other than `apart_m` and look the same way.
bool are_neighbours(const Camera& a, const Camera& b, double apart_m);

/// The cameras of most worth among those of which no two are neighbours, at most `most` of them.
std::vector<Candidate> distinct_cameras(const SpreadCameras& spread, std::size_t most);

}  // namespace aoscore
