#pragma once

#include "results/results.h"

#include <optional>
#include <string>

namespace aoscore {

/// Advice as a table of text: what was asked, a line a step with the best buy first, and what is left out.
std::string advice_table(const Results& results, const AdviceRecord& advice);

/// One sentence: the step that takes most error off for its time, or that none does so surely.
std::string advice_sentence(const Results& results, const AdviceRecord& advice);

/// That sentence for the closest of the cells of the first view that have advice; empty where none has.
std::string leading_advice(const Results& results);

/// Error that a millisecond or a fetch a pixel takes off; empty where the step takes no more of them.
std::optional<double> bought_per_ms(const StepRecord& step, double before);
std::optional<double> bought_per_fetch(const StepRecord& step, double before);

/// A step in words: "more taps (steps 6 to 12)".
std::string step_name(const StepRecord& step);

}  // namespace aoscore
