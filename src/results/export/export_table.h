#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One column of numbers.
struct ExportColumn {
    std::string key;    ///< its name in CSV and JUnit: "fetches_per_pixel"
    std::string label;  ///< its name in Markdown and LaTeX, with its unit: "AO (ms)"
    int decimals = 4;   ///< decimals in Markdown and LaTeX; CSV and JUnit have all digits
    bool brief = true;  ///< also in tables for readers, whose width is limited (see reader_table.h)
};

/// One image that was measured.
struct ExportRow {
    std::string name;                            ///< its name within its group, for formats that name rows
    std::vector<std::string> names;              ///< one for each name column
    std::vector<std::optional<double>> numbers;  ///< one for each number column; empty where missing
    std::vector<std::string> texts;              ///< one for each text column
    std::string error;                           ///< the error of a cell that failed; else empty
    std::vector<std::string> failures;           ///< tripped gates, one line each
};

/// The table that every export format writes.
struct ExportTable {
    std::string title;                      ///< the command of the run
    std::vector<std::string> name_columns;  ///< rows are grouped by the first
    std::vector<ExportColumn> columns;
    std::vector<std::string> text_columns;  ///< keys, for CSV and JUnit
    std::vector<std::string> notes;         ///< sentences about the table, for Markdown and LaTeX
    std::vector<ExportRow> rows;
    nlohmann::json document;  ///< the full results, for JSON
};

/// Makes a table with a row for each cell. `failures` has the tripped gates by cell id.
ExportTable export_table(const Results& results,
                         const std::map<std::string, std::vector<std::string>>& failures = {});

/// Adds the columns and numbers of metrics and analysis, which every export has.
void add_measures(ExportTable& table);
std::vector<std::optional<double>> measures_of(const MetricMap& metrics,
                                               const std::optional<ErrorAnalysis>& analysis);

}  // namespace aoscore
