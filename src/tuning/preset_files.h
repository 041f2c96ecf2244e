#pragma once

#include "tuning/tuning_run.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace aoscore {

/// The settings by parameter, as a preset has them.
ParameterValues values_of(const std::vector<SearchAxis>& axes, const Settings& settings);

/// The id of the preset that was tuned from one, for a budget: "tuned", "nvidia-tuned-24", "tuned-8-5ms".
std::string tuned_preset_id(const std::string& from, const Budget& budget);

/// The files of presets by method, which --preset takes (see add_presets()), with how each was tuned.
std::map<std::string, nlohmann::json> preset_files(const TuningResults& results, const TuningPlan& plan);

/// Writes them into the folders of the program's own methods, as kTunedPresets: they are presets of these
/// methods from then on, in place of those that the file had. Returns the files' paths. Throws usage_error
/// for a method of another folder.
std::vector<std::filesystem::path> install_presets(const TuningResults& results, const TuningPlan& plan);

}  // namespace aoscore
