#pragma once

#include "results/results.h"

#include <vector>

namespace aoscore {

/// The views sorted into groups that one number may cover: ranked at the same radius, in pictures of the same
/// size. An error at one radius and one at another answer different questions, as do those of a large and of
/// a small picture, and no mean of them answers either. Groups and their views keep the order of `views`.
std::vector<std::vector<const ViewRecord*>> comparable_views(const std::vector<const ViewRecord*>& views);

}  // namespace aoscore
