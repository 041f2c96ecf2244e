#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace aoscore {

/// Each value may take 300 bytes, as JSON and in the structs that it is read into.
inline constexpr std::size_t kMostJsonValues = 4'000'000;

/// Parses a text that may be hostile: nesting and the number of values are limited before anything is built.
/// Throws file_error naming `where` and the line; `valid` says what the text should be, such as "glTF 2.0".
nlohmann::json parse_json_text(std::string_view text, const std::string& where, const std::string& valid,
                               std::size_t most_values = kMostJsonValues);

/// Writes the value as text. Names of files may hold any bytes, JSON only UTF-8: others become U+FFFD.
std::string json_text(const nlohmann::json& value, int indent = -1);

/// Writes the value as a message quotes it: in full where it is short.
std::string quoted_json(const nlohmann::json& value);

}  // namespace aoscore
