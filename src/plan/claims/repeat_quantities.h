#pragma once

#include "plan/claims/quantity.h"

#include <cstdint>

/// What cells are measured to be when they are drawn again (metrics/analysis/repeats.h): rows of
/// quantities(). Intervals are those of resampled blocks of the picture, drawn alike in all cells of a view.
namespace aoscore::repeat_quantities {

Measured repeats_noise(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured repeats_raw_noise(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured repeats_fitted_noise(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured unconverged(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured raw_unconverged(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured raw_unconverged_bands(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured found_of_truth(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured found_of_grazing(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured unevenness_of_truth(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured unevenness_of_grazing(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured found_of_layers(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured found_fitted_of_layers(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured kept_of_layers(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured finders_of_layers(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured hidden_bent_angle(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured other_bent_angle(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured hidden_cone_error(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured hidden_cone_bias(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
Measured other_cone_error(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);

}  // namespace aoscore::repeat_quantities
