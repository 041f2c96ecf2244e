#pragma once

#include <string>

namespace aoscore {

/// The argument as a POSIX shell must be given it: in quotes where it needs them.
std::string shell_quoted(const std::string& argument);

}  // namespace aoscore
