#pragma once

#include "reference/truth.h"

#include <cstddef>

namespace aoscore {

/// Settings of one of the two independent halves of a truth with TruthSettings::halves: half as many rays,
/// and a seed that neither the other half nor an undivided truth has. `half` is 0 or 1.
TruthSettings settings_of_half(const TruthSettings& settings, std::size_t half);

/// The truth whose rays are those of both: visibility is the mean of the two, the standard error that of the
/// mean, and Truth::halves keeps each. Both must be of one picture, with the same queries, settings and
/// extras but for the seed.
Truth mean_of_halves(Truth first, Truth second);

}  // namespace aoscore
