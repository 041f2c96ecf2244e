#pragma once

#include "cli/manual/option_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The shells that completion_script() knows.
inline constexpr std::string_view kShells[] = {"bash", "zsh", "fish"};

/// A script for the shell that completes commands, options and their values. Names of methods and scenes are
/// asked of the program when they are needed, so that a user's own appear.
std::string completion_script(std::string_view shell, const std::vector<CommandRow>& commands);

}  // namespace aoscore
