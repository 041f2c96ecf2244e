#pragma once

#include "plan/claims/quantity.h"

#include <cstdint>

/// What cells are measured to cost: rows of quantities(). Every time of a claim is processor time of all
/// threads, which other work on the machine moves far less than the clock's, taken in turns with the other
/// settings of its view.
namespace aoscore::time_quantities {

/// The standard deviation of the logarithm of a pass's processor time from run to run of the program. Eight
/// methods on a quiet machine, beside two busy loops and beside a trace on all cores differ by .057 between
/// two runs once what all of them share is taken off, which is .04 for each. It widens every interval, so
/// that what else runs on a machine leaves a claim untold rather than decided otherwise.
inline constexpr double kLoadSpread = 0.05;

/// Processor time of all threads, milliseconds; empty without two timed runs, and on a GPU. `seed` is that of
/// the resampling.
Measured ao_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured ao_without_layers_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured layers_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured filter_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured cost_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
/// Parts of another time, 0 and more.
Measured filter_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured filter_over_ao(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
/// Milliseconds for a fetch a pixel, for a million valid pixels, and in passes of sixteen fetches.
Measured per_fetch(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured per_megapixel(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured relative(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
/// Milliseconds.
Measured lighting_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured frame_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
/// Parts of another time, 0 and more; the last is the spread of the runs over their median.
Measured cost_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured cost_over_rest(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured filter_over_lighting(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured waiting(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured variation(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);

}  // namespace aoscore::time_quantities
