#pragma once

#include <string_view>

namespace aoscore {

/// With quiet set, only errors reach the terminal.
void set_quiet(bool quiet);
bool quiet();

/// Writes a line to standard error that says what is being done. Standard output is for results alone.
void log_info(std::string_view line);
/// Writes a line to standard error that begins with "warning: ".
void log_warning(std::string_view line);
/// Writes an error to standard error, in quiet runs too.
void log_error(std::string_view line);

}  // namespace aoscore
