#pragma once

#include "framing/candidate.h"

#include <vector>

namespace aoscore {

/// Where to stand: at three quarters only, or straight before each side as well.
enum class Around { three_quarters, straight_too };

/// Views from outside: the best one of several directions and heights, fitted to the outline of the main
/// part, and the best one from another side. The first prefers the front, +z. May be fewer than `count`.
std::vector<Candidate> outside_cameras(const Trial& trial, Around around, std::size_t count);

}  // namespace aoscore
