#include "scene/gltf/json_text.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace aoscore::gltf {
namespace {

constexpr int kMaxDepth = 128;
/// Each may come to 300 bytes, as JSON and as tinygltf's structs.
constexpr std::size_t kMaxValues = 4'000'000;

std::string line_place(std::string_view text, std::size_t byte, const std::string& where) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return fmt::format("{}: line {} of the JSON", where, std::count(before.begin(), before.end(), '\n') + 1);
}

void measure(std::string_view text, const std::string& where) {
    int depth = 0;
    std::size_t values = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '[' || c == '{' || c == ',') ++values;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > kMaxDepth) {
            throw file_error(fmt::format("nested deeper than {} levels", kMaxDepth),
                             line_place(text, i, where));
        }
        if (values > kMaxValues) {
            throw file_error(fmt::format("more than {} values", kMaxValues), line_place(text, i, where));
        }
    }
}

}  // namespace

nlohmann::json parse_json_text(std::string_view text, const std::string& where) {
    measure(text, where);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& e) {
        throw file_error("is not JSON", line_place(text, e.byte, where), "glTF 2.0");
    } catch (const nlohmann::json::exception&) {
        throw file_error("holds a number that no double holds", where + ": JSON", "glTF 2.0");
    }
}

}  // namespace aoscore::gltf
