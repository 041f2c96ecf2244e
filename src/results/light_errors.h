#pragma once

#include "results/light_modes.h"
#include "results/results.h"

#include <map>
#include <optional>
#include <string>

namespace aoscore {

/// A relative error of light, and the mode that has it.
struct LightError {
    const MeasureRecord* error;
    const LightMode* mode;
};

/// The least relative error over the modes that these measures of a cell (CellRecord::light) have; empty
/// where they have none.
std::optional<LightError> least_light_error(const std::map<std::string, MeasureRecord>& light);

}  // namespace aoscore
