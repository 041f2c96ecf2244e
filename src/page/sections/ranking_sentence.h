#pragma once

#include "results/results.h"

#include <string>
#include <vector>

namespace aoscore {

using Places = std::vector<const PlaceRecord*>;

/// The places that have a rank, in the order of their error.
Places ranked_places(const RankingRecord& ranking);

/// The ranked places that may have the least error.
Places leaders_of(const RankingRecord& ranking);

/// A sentence that says which method is closest, and by how much.
std::string ranking_sentence(const RankingRecord& ranking);

/// A sentence with the errors of a ranking's bounds; empty without any.
std::string bounds_sentence(const RankingRecord& ranking);

/// A sentence that compares the cost of the closest method on a view with the next one's; empty where neither
/// times nor fetches of both are known, or only one method is ranked.
std::string cost_sentence(const Results& results, const RankingRecord& ranking);

}  // namespace aoscore
