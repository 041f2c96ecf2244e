#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One column of numbers.
struct ExportColumn {
    std::string key;    ///< of CSV and JUnit: "fetches_per_pixel"
    std::string label;  ///< of Markdown and LaTeX, with its unit: "AO (ms)"
    int decimals = 4;   ///< of Markdown and LaTeX; CSV and JUnit have all digits
    bool brief = true;  ///< also in tables for readers, which a page's width limits
};

/// One image that was measured.
struct ExportRow {
    std::string name;                            ///< within its group, for formats that name rows
    std::vector<std::string> names;              ///< one a name column
    std::vector<std::optional<double>> numbers;  ///< one a number column; empty where it could not be had
    std::vector<std::string> texts;              ///< one a text column
    std::string error;                           ///< why it failed; empty when it did not
    std::vector<std::string> failures;           ///< tripped gates, one line each
};

/// What every format of an export writes.
struct ExportTable {
    std::string title;                      ///< the command that made it
    std::vector<std::string> name_columns;  ///< the first groups the rows
    std::vector<ExportColumn> columns;
    std::vector<std::string> text_columns;  ///< keys, of CSV and JUnit
    std::vector<std::string> notes;         ///< sentences about the whole table, of Markdown and LaTeX
    std::vector<ExportRow> rows;
    nlohmann::json document;  ///< the same and more, for JSON
};

/// One row a cell. `failures` by cell id.
ExportTable export_table(const Results& results,
                         const std::map<std::string, std::vector<std::string>>& failures = {});

/// The columns and numbers that metrics and analysis give, which every export has.
void add_measures(ExportTable& table);
std::vector<std::optional<double>> measures_of(const MetricMap& metrics,
                                               const std::optional<ErrorAnalysis>& analysis);

}  // namespace aoscore
