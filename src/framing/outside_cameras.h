#pragma once

#include "framing/candidate.h"

#include <vector>

namespace aoscore {

/// The directions to try: three-quarter views only, or also straight before each side.
enum class Around { three_quarters, straight_too };

/// Views from outside: the best one of several directions and heights, fitted to the outline of the main
/// part, and the best one from another side. The first prefers the front, +z. There may be fewer than
/// `count`.
std::vector<Candidate> outside_cameras(const Trial& trial, Around around, std::size_t count);

}  // namespace aoscore
