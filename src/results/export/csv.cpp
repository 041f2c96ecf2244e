#include "results/export/export_format.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string line(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + quoted(fields[i]);
    return text + "\r\n";
}

}  // namespace

std::string export_as::csv(const ExportTable& table) {
    std::vector<std::string> head = table.name_columns;
    for (const ExportColumn& column : table.columns) head.push_back(column.key);
    head.emplace_back("error");
    std::string text = line(head);
    for (const ExportRow& row : table.rows) {
        std::vector<std::string> fields = row.names;
        for (const auto& number : row.numbers) fields.push_back(number ? fmt::format("{}", *number) : "");
        fields.push_back(row.error);
        text += line(fields);
    }
    return text;
}

}  // namespace aoscore
