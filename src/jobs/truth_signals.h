#pragma once

#include "core/signal.h"
#include "reference/truth.h"
#include "results/results.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// What the truth must gather for these signals.
TruthExtras extras_for(std::span<const std::string> signals);

/// Those beside visibility that the truth was asked for.
std::vector<std::string> held_signals(const Truth& truth);

/// A signal beside visibility as the truth has it.
struct TruthSignal {
    SignalImage image;
    const ImageF* standard_error_rad;  ///< the truth's own
};

/// Throws internal_error for a signal that the truth was not asked for.
TruthSignal truth_signal(const Truth& truth, std::string_view id);

/// What the results say of the signals that the truth holds, over the `valid` pixels.
std::vector<SignalRecord> recorded_signals(const Truth& truth, const Mask& valid);

}  // namespace aoscore
