#pragma once

#include "core/error.h"

#include <string>
#include <vector>

namespace aoscore {

/// Runs the command that these words, as arguments() gives them, stand for. `command_line` is what results
/// name as the command that makes them again.
ExitCode run_words(const std::vector<std::string>& words, const std::string& command_line);

}  // namespace aoscore
