#include "results/export/csv_line.h"

#include "core/printable.h"

#include <charconv>
#include <string_view>

namespace aoscore {
namespace {

bool is_number(const std::string& text) {
    double value = 0;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    return ec != std::errc::invalid_argument && end == text.data() + text.size();
}

/// Puts an apostrophe before a text that begins like a formula: spreadsheets would compute it, whatever file
/// it came from (OWASP, CSV Injection).
std::string no_formula(const std::string& text) {
    constexpr std::string_view kBegins = "=+-@\t\r";
    const bool formula = !text.empty() && kBegins.find(text[0]) != kBegins.npos && !is_number(text);
    return formula ? "'" + text : text;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i)
        text += (i > 0 ? "," : "") + quoted(no_formula(printable_lines(fields[i])));
    return text + "\r\n";
}

}  // namespace aoscore
