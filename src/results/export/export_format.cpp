#include "results/export/export_format.h"

#include "core/error.h"
#include "core/json_text.h"
#include "core/known_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace aoscore {

const std::vector<ExportFormat>& export_formats() {
    static const std::vector<ExportFormat> table = {
        {".csv", "CSV", export_as::csv},          {".json", "JSON", export_as::json},
        {".md", "Markdown", export_as::markdown}, {".tex", "LaTeX", export_as::latex},
        {".xml", "JUnit", export_as::junit},
    };
    return table;
}

const ExportFormat& export_format(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (const auto format = find_row(export_formats(), extension, &ExportFormat::extension)) return *format;
    std::vector<std::string_view> known;
    for (const ExportFormat& format : export_formats()) known.push_back(format.extension);
    throw usage_error(fmt::format("no format has the extension \"{}\"", extension), path.string(),
                      fmt::format("{}", fmt::join(known, ", ")));
}

std::string export_as::json(const ExportTable& table) {
    return json_text(table.document, 1) + "\n";
}

std::string brief_number(const std::optional<double>& number, int decimals) {
    return number ? fmt::format("{:.{}f}", *number, decimals) : "–";
}

}  // namespace aoscore
