#pragma once

#include "results/results.h"

#include <vector>

namespace aoscore {

/// Sorts the views into groups of one ranking radius and one picture size, over which errors may be averaged.
/// Errors at different radii answer different questions, as do those of a large and a small picture, and no
/// mean of them answers either. Groups and their views keep the order of `views`.
std::vector<std::vector<const ViewRecord*>> comparable_views(const std::vector<const ViewRecord*>& views);

}  // namespace aoscore
