#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// What a place is called in a sentence: its method with its setting, and its preset and filter where
/// another place of the ranking differs from it in these alone.
std::string place_name(const RankingRecord& ranking, const PlaceRecord& place);

}  // namespace aoscore
