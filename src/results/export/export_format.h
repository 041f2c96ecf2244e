#pragma once

#include "results/export/export_table.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A format of exports: a row of the table in export_format.cpp, and a source file of its own.
struct ExportFormat {
    std::string_view extension;  ///< ".csv"
    std::string_view label;
    std::string (*write)(const ExportTable& table);
};

const std::vector<ExportFormat>& export_formats();

/// The format of a path's extension. Throws usage_error for an unknown one, listing the known ones.
const ExportFormat& export_format(const std::filesystem::path& path);

namespace export_as {
std::string csv(const ExportTable& table);    ///< RFC 4180; a missing number is empty
std::string json(const ExportTable& table);   ///< writes ExportTable::document
std::string junit(const ExportTable& table);  ///< a test case a row, numbers as properties, gates as failures
std::string latex(const ExportTable& table);  ///< a tabular with the rules of booktabs
std::string markdown(const ExportTable& table);  ///< a pipe table
}  // namespace export_as

/// The number with so many decimals, for readers; "–" where there is none.
std::string brief_number(const std::optional<double>& number, int decimals);

}  // namespace aoscore
