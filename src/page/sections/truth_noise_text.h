#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// Says in a sentence how certain a view's scores are with the truth's noise; empty where its truth has no
/// halves.
std::string truth_noise_text(const Results& results, const ViewRecord& view);

/// Says that a page shows the first answer of a run that goes on, and which parts are final; empty for a
/// final page.
std::string first_answer_text(const Results& results);

}  // namespace aoscore
