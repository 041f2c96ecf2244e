#pragma once

#include <filesystem>
#include <string_view>

namespace aoscore {

/// The path of the running program.
std::filesystem::path program_path();

/// The path of what is built beside the running program. Throws internal_error where it is not there.
std::filesystem::path beside_program(std::string_view name);

}  // namespace aoscore
