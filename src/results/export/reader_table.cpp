#include "results/export/reader_table.h"

#include <algorithm>

namespace aoscore {
namespace {

/// The number of characters, which in UTF-8 begin with another byte than 10xxxxxx.
std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

void fill(std::string& text, std::size_t width, bool at_left) {
    const std::string blanks(width - std::min(width, characters(text)), ' ');
    text = at_left ? blanks + text : text + blanks;
}

}  // namespace

ReaderTable::ReaderTable(const ExportTable& table, const CellTexts& texts) : rows(table.rows.size()) {
    const auto some = [&](const auto& has) {
        return table.rows.empty() || std::ranges::any_of(table.rows, has);
    };
    for (std::size_t c = 0; c < table.name_columns.size(); ++c) {
        if (table.name_columns[c] == "role") continue;
        if (!some([&](const ExportRow& row) { return !row.names[c].empty(); })) continue;
        heads.push_back(texts.text(table.name_columns[c]));
        is_number.push_back(false);
        for (std::size_t r = 0; r < rows.size(); ++r) rows[r].push_back(texts.text(table.rows[r].names[c]));
    }
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const ExportColumn& column = table.columns[c];
        if (!column.brief || !some([&](const ExportRow& row) { return row.numbers[c].has_value(); }))
            continue;
        heads.push_back(texts.text(column.label));
        is_number.push_back(true);
        for (std::size_t r = 0; r < rows.size(); ++r)
            rows[r].push_back(texts.number(table.rows[r].numbers[c], column.decimals));
    }
}

std::size_t ReaderTable::width(std::size_t column) const {
    std::size_t most = characters(heads[column]);
    for (const auto& row : rows) most = std::max(most, characters(row[column]));
    return most;
}

void ReaderTable::align() {
    for (std::size_t c = 0; c < heads.size(); ++c) {
        const std::size_t most = width(c);
        fill(heads[c], most, is_number[c]);
        for (auto& row : rows) fill(row[c], most, is_number[c]);
    }
}

}  // namespace aoscore
