#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// The name of a place in a sentence: its method with its setting, and its preset and filter where another
/// place differs only in these.
std::string place_name(const RankingRecord& ranking, const PlaceRecord& place);

}  // namespace aoscore
