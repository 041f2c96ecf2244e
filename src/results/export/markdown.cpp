#include "core/printable.h"
#include "results/export/export_format.h"
#include "results/export/reader_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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
    ReaderTable shown(table, {markdown_escaped, brief_number});
    // A rule has at least three hyphens, and a colon where numbers stand at the right.
    for (std::size_t c = 0; c < shown.heads.size(); ++c)
        shown.heads[c].resize(std::max<std::size_t>(shown.heads[c].size(), 4), ' ');
    shown.align();
    std::string rule = "|";
    for (std::size_t c = 0; c < shown.heads.size(); ++c) {
        const std::string hyphens(shown.width(c) - (shown.is_number[c] ? 1 : 0), '-');
        rule += " " + hyphens + (shown.is_number[c] ? ": |" : " |");
    }
    const auto line = [](const std::vector<std::string>& cells) {
        return fmt::format("| {} |\n", fmt::join(cells, " | "));
    };
    std::string text = line(shown.heads) + rule + "\n";
    for (const auto& row : shown.rows) text += line(row);
    for (const std::string& note : table.notes) text += "\n" + markdown_escaped(note) + "\n";
    for (const ExportRow& row : table.rows) {
        if (!row.error.empty())
            text += fmt::format("\n{} failed: {}\n", markdown_escaped(row.name), markdown_escaped(row.error));
    }
    return text;
}

}  // namespace aoscore
