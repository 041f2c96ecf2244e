#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// The class of a verdict's mark on the page.
std::string verdict_style(const std::string& verdict);

/// "1.25 ms (1.00 to 1.50)": a number with its interval, where that is one.
std::string measured_text(const ClaimFinding& finding);

/// "0.5 to 2", "above 0": the range that a claim gives a number; empty where it gives none.
std::string claimed_text(const ClaimFinding& finding);

/// "of 5 claims 3 hold, 1 does not hold and 1 cannot be told here".
std::string verdict_counts_text(std::size_t claims, std::size_t hold, std::size_t fail);

/// The numbers that decided a claim, or why none could: those of its first part that has the claim's verdict.
std::string deciding_text(const ClaimRecord& claim);

}  // namespace aoscore
