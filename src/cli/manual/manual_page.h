#pragma once

#include "cli/manual/option_table.h"

#include <string>

namespace aoscore {

/// A manual page of section 1 in the macros of man(7): that of one command, or of the program, which lists
/// `all` commands. `end` is the text below the options, such as the exit codes.
std::string manual_page(const CommandRow& command, const std::vector<CommandRow>& all,
                        const std::string& end);

/// The name of its file: aoscore.1, or aoscore-score.1.
std::string manual_file(const CommandRow& command);

}  // namespace aoscore
