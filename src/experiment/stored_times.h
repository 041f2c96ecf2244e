#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The timed runs of a cell as they are kept, with the fixed pass that was timed in the same rounds.
struct StoredTimes {
    std::vector<double> ao_ms, filter_ms;
    double fixed_pass_ms = 0;
};
nlohmann::json to_json(const StoredTimes& times);
/// Throws file_error for another form.
StoredTimes stored_times_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
