#pragma once

#include "core/signal.h"
#include "reference/truth.h"
#include "results/results.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The extras that the truth must trace for these signals.
TruthExtras extras_for(std::span<const std::string> signals);

/// The signals beside visibility that the truth holds.
std::vector<std::string> held_signals(const Truth& truth);

/// A signal beside visibility of the truth.
struct TruthSignal {
    SignalImage image;
    const ImageF* standard_error_rad;  ///< the truth's own
};

/// The truth's signal. Throws internal_error for one that it does not hold.
TruthSignal truth_signal(const Truth& truth, std::string_view id);

/// The records of the truth's signals in the results, over the `valid` pixels.
std::vector<SignalRecord> recorded_signals(const Truth& truth, const Mask& valid);

}  // namespace aoscore
