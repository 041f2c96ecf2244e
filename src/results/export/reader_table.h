#pragma once

#include "results/export/export_table.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// How a format for readers writes what stands in a cell.
struct CellTexts {
    std::string (*text)(const std::string& text);
    std::string (*number)(const std::optional<double>& number, int decimals);
};

/// An export as the page's ranking shows it: without the role, which a rank says, and without columns that
/// are empty in every row.
struct ReaderTable {
    std::vector<std::string> heads;
    std::vector<bool> is_number;  ///< by column; numbers stand at the right
    std::vector<std::vector<std::string>> rows;

    ReaderTable(const ExportTable& table, const CellTexts& texts);
    /// Fills every cell, and every head, with blanks to the width of its column.
    void align();
    /// The width of a column, in characters.
    std::size_t width(std::size_t column) const;
};

}  // namespace aoscore
