#pragma once

#include "jobs/timing.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The stored runs of a cell, with the fixed pass and the lighting that were timed in the same rounds. Passes
/// that were not asked for have no runs.
struct StoredTimes {
    PassRuns ao, filter, fixed_pass, lighting;
    PassRuns frame_at_once, frame_by_pass;
    std::vector<double> layers_processor_ms;
    PassRuns gbuffer;  ///< of the picture with its guard band
    double gbuffer_bytes = 0;

    /// Whether these runs suffice for a request: as many as `goal` asks for (any number without one), and
    /// whole frames where they are wanted.
    bool serve(const std::optional<TimingGoal>& goal, bool whole_frames) const;
};
nlohmann::json to_json(const StoredTimes& times);
/// Reads stored times. Throws file_error for another form.
StoredTimes stored_times_from_json(const nlohmann::json& json, const std::string& where);

nlohmann::json to_json(const PassRuns& runs);
/// Reads the runs of a pass. Throws file_error for another form.
PassRuns pass_runs_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
