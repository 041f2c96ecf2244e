#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace aoscore::gltf {

/// Parses the JSON of a glTF file. The text is measured before it is parsed: nesting deeper than any glTF (a
/// recursive parser would overflow its stack) and more values than memory allows are refused. Throws
/// file_error that names the line, never the content.
nlohmann::json parse_json_text(std::string_view text, const std::string& where);

}  // namespace aoscore::gltf
