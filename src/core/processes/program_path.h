#pragma once

#include <filesystem>
#include <string_view>

namespace aoscore {

/// The path of the running program.
std::filesystem::path program_path();

/// The path of what comes with the running program: beside it, as built, or in ../lib/aoscore, as installed. Throws
/// internal_error where it is in neither.
std::filesystem::path beside_program(std::string_view name);

}  // namespace aoscore
