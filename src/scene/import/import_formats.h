#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace aoscore::imported {

/// The scene files that are read by the importing program.
enum class Format : std::uint8_t { obj, fbx, ply, stl };

/// The format of a file by its extension, in any letter case; nothing for another extension.
std::optional<Format> format_of(const std::filesystem::path& file);

/// The name of a format, such as "OBJ".
std::string_view format_name(Format format);

}  // namespace aoscore::imported
