#pragma once

#include <nlohmann/json.hpp>

namespace aoscore {

/// The JSON Schema (draft 2020-12) of results.json, made of the list of members that writes and reads it.
nlohmann::json results_schema();

}  // namespace aoscore
