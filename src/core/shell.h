#pragma once

#include <string>

namespace aoscore {

/// The argument as a POSIX shell must be given it: in quotes where it needs them, those of $'...' (POSIX
/// 2024) where it holds what is not fit to be shown.
std::string shell_quoted(const std::string& argument);

}  // namespace aoscore
