#pragma once

#include "core/strict_json.h"
#include "screen/method/method.h"

#include <nlohmann/json.hpp>

namespace aoscore {

/// Writes how a preset was tuned as a member of "tunings" in a file of presets.
nlohmann::json tuning_json(const PresetTuning& tuning);

/// Reads such a member. Throws file_error for another form.
PresetTuning parse_tuning(StrictObject object);

}  // namespace aoscore
