#pragma once

#include "core/error.h"

#include <string>
#include <vector>

namespace aoscore {

/// Runs the command of these words, which come from arguments(). Results give `command_line` as the command
/// that makes them again.
ExitCode run_words(const std::vector<std::string>& words, const std::string& command_line);

}  // namespace aoscore
