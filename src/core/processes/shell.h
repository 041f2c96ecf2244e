#pragma once

#include <string>

namespace aoscore {

/// The argument as it is typed in a POSIX shell: in quotes where it needs them, as $'...' (POSIX 2024) where
/// it holds characters that are not printable().
std::string shell_quoted(const std::string& argument);

}  // namespace aoscore
