#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// What the truth's noise leaves of a view's scores, in a sentence; empty where its truth has no halves that
/// tell.
std::string truth_noise_text(const Results& results, const ViewRecord& view);

/// That a page shows the first answer of a run that goes on, and what in it is final; empty for a final page.
std::string first_answer_text(const Results& results);

}  // namespace aoscore
