#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace aoscore {

/// Checks that live.json has the form that a run writes (results/live_file.h, screen/method_data.h), so that
/// the page's scripts may rely on it: every member is there, of its type and range, and there is no other.
/// Throws file_error that says what is wrong and where; `name` is the file's.
void check_live_index(const nlohmann::json& index, const std::string& name);

}  // namespace aoscore
