#pragma once

#include "results/export/export_table.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// One way to write an export: a row of the table in export_format.cpp, and a file of its own.
struct ExportFormat {
    std::string_view extension;  ///< ".csv"
    std::string_view label;
    std::string (*write)(const ExportTable& table);
};

const std::vector<ExportFormat>& export_formats();

/// The format of a path's extension. Throws usage_error for another one, listing those there are.
const ExportFormat& export_format(const std::filesystem::path& path);

namespace export_as {
std::string csv(const ExportTable& table);    ///< RFC 4180; a number that could not be had is empty
std::string json(const ExportTable& table);   ///< the document
std::string junit(const ExportTable& table);  ///< a test case a row, numbers as properties, gates as failures
std::string latex(const ExportTable& table);  ///< a tabular with the rules of booktabs
std::string markdown(const ExportTable& table);  ///< a pipe table
}  // namespace export_as

/// For tables for readers: with that many decimals; "–" where there is no number.
std::string brief_number(const std::optional<double>& number, int decimals);

}  // namespace aoscore
