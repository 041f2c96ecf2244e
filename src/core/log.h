#pragma once

#include <string_view>

namespace aoscore {

/// With quiet set, only errors reach the terminal.
void set_quiet(bool quiet);
bool quiet();

/// A line on standard error: what is being done. Standard output is for results alone.
void log_info(std::string_view line);
/// A line on standard error that begins with "warning: ".
void log_warning(std::string_view line);
/// A line on standard error that even a quiet run needs: why it ends otherwise than well.
void log_error(std::string_view line);

}  // namespace aoscore
