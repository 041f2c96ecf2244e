#pragma once

#include "plan/claims/claim.h"
#include "results/results.h"

#include <vector>

namespace aoscore {

/// Judges every claim of the lists by the results. A part of a claim holds when the interval of its
/// expression lies wholly inside the claimed range, fails when it lies wholly outside, and cannot be decided
/// when it straddles a limit or a cell was not measured. A claim holds when all its parts do and does not
/// when one of them fails.
std::vector<ClaimRecord> judge_claims(const std::vector<ClaimList>& lists, const Results& results);

/// The verdict in a line: "H01 holds: … (Hussain, …, 2022, section 5.2)".
std::string verdict_text(const ClaimRecord& claim);

/// A table of how many claims hold, do not, and cannot be told: a line for each source and one for all.
std::string verdict_table(const std::vector<ClaimRecord>& claims);

/// A line for each claim that has another verdict than `before`, or none there: "V13 holds, before: does not
/// hold"; one that says so where none has. Then which claims were judged before alone, and whether the same
/// views had another size.
std::string changed_verdicts(const Results& now, const Results& before);

}  // namespace aoscore
