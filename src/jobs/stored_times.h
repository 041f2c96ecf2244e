#pragma once

#include "jobs/timing.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The stored runs of a cell, with the fixed pass and the lighting that were timed in the same rounds. Passes
/// that were not asked for have no runs.
struct StoredTimes {
    std::vector<double> ao_ms, filter_ms;
    double fixed_pass_ms = 0;
    std::vector<double> lighting_ms;
    std::vector<double> frame_at_once_ms, frame_by_pass_ms;
    std::vector<double> ao_processor_ms, layers_processor_ms;
    std::vector<double> gbuffer_ms;  ///< of the picture with its guard band
    double gbuffer_bytes = 0;

    /// Whether these runs suffice for a request: as many as `goal` asks for (any number without one), and
    /// whole frames where they are wanted.
    bool serve(const std::optional<TimingGoal>& goal, bool whole_frames) const;
};
nlohmann::json to_json(const StoredTimes& times);
/// Reads stored times. Throws file_error for another form.
StoredTimes stored_times_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
