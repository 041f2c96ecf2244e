#pragma once

#include "framing/candidate.h"

#include <vector>

namespace aoscore {

/// Three-quarter views from outside: the best one of several directions and heights, fitted to the outline of
/// the main part, and the best one from another side. The first prefers the front, +z.
std::vector<Candidate> outside_cameras(const Trial& trial, std::size_t count);

}  // namespace aoscore
