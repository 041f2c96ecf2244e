#include "core/json_text.h"

#include "core/error.h"
#include "core/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 128;

std::string line_place(std::string_view text, std::size_t byte, const std::string& where) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const std::size_t last_break = before.rfind('\n');
    const std::size_t column = before.size() - (last_break == before.npos ? 0 : last_break + 1);
    return fmt::format("{}: line {}, column {} of the JSON", where,
                       std::count(before.begin(), before.end(), '\n') + 1, column);
}

// The position of the number that the parser quotes because no double holds it.
std::size_t byte_of_quoted(std::string_view text, std::string_view message) {
    const std::size_t first = message.find('\''), last = message.rfind('\'');
    if (first == last) return 0;
    return std::min(text.find(message.substr(first + 1, last - first - 1)), text.size() - 1) + 1;
}

void measure(std::string_view text, const std::string& where, std::size_t most_values) {
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
        if (values > most_values) {
            throw file_error(fmt::format("more than {} values", most_values), line_place(text, i, where));
        }
    }
}

}  // namespace

json parse_json_text(std::string_view text, const std::string& where, const std::string& valid,
                     std::size_t most_values) {
    measure(text, where, most_values);
    try {
        return json::parse(text);
    } catch (const json::parse_error& e) {
        throw file_error("is not JSON", line_place(text, e.byte, where), valid);
    } catch (const json::exception& e) {
        throw file_error("is a number that no double holds",
                         line_place(text, byte_of_quoted(text, e.what()), where), valid);
    }
}

std::string json_text(const json& value, int indent) {
    return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

std::string quoted_json(const json& value) {
    constexpr std::size_t kLongest = 80;
    if (value.is_structured()) return value.type_name();
    const std::string text = printable(json_text(value));
    return text.size() <= kLongest ? text : std::string("a long ") + value.type_name();
}

}  // namespace aoscore
