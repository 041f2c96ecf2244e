#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// What of the results a baseline is compared in, and what not, in a sentence: "Compared is visibility alone,
/// not the errors of light." Only its error can be resampled in pairs, block by block.
std::string baseline_scope(const Results& results);

}  // namespace aoscore
