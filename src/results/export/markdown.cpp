#include "core/printable.h"
#include "results/export/export_format.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

std::string markdown_escaped(const std::string& text) {
    std::string result;
    for (const char c : printable_lines(text)) {
        if (c == '|' || c == '\\' || c == '*' || c == '_' || c == '`' || c == '<') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

}  // namespace

std::string export_as::markdown(const ExportTable& table) {
    std::string head = "|", rule = "|";
    for (const std::string& name : table.name_columns) {
        head += " " + markdown_escaped(name) + " |";
        rule += " --- |";
    }
    for (const ExportColumn& column : table.columns) {
        if (!column.brief) continue;
        head += " " + markdown_escaped(column.label) + " |";
        rule += " ---: |";
    }
    std::string text = head + "\n" + rule + "\n";
    for (const ExportRow& row : table.rows) {
        text += "|";
        for (const std::string& name : row.names) text += " " + markdown_escaped(name) + " |";
        for (std::size_t i = 0; i < row.numbers.size(); ++i) {
            if (table.columns[i].brief)
                text += " " + brief_number(row.numbers[i], table.columns[i].decimals) + " |";
        }
        text += "\n";
    }
    for (const std::string& note : table.notes) text += "\n" + markdown_escaped(note) + "\n";
    for (const ExportRow& row : table.rows) {
        if (!row.error.empty())
            text += fmt::format("\n{} failed: {}\n", markdown_escaped(row.name), markdown_escaped(row.error));
    }
    return text;
}

}  // namespace aoscore
