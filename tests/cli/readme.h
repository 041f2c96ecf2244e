#pragma once

#include "support/support.h"

#include <filesystem>
#include <string>

namespace aoscore::testing {

/// The indented lines of a section of README.md.
std::string readme_commands(const std::string& heading);

/// Runs these lines with bash, in `folder`. There `./run.sh` is the built program, which gets
/// `score_arguments` added to its command `score`, to be quick, and a truth cache of its own; `shaders` is
/// the project's.
ProgramRun run_readme_commands(const std::string& heading, const std::filesystem::path& folder,
                               const std::string& score_arguments = {});

}  // namespace aoscore::testing
