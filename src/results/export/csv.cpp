#include "results/export/csv_line.h"
#include "results/export/export_format.h"

#include <fmt/format.h>

namespace aoscore {
std::string export_as::csv(const ExportTable& table) {
    std::vector<std::string> head = table.name_columns;
    for (const ExportColumn& column : table.columns) head.push_back(column.key);
    head.insert(head.end(), table.text_columns.begin(), table.text_columns.end());
    head.emplace_back("error");
    std::string text = csv_line(head);
    for (const ExportRow& row : table.rows) {
        std::vector<std::string> fields = row.names;
        for (const auto& number : row.numbers) fields.push_back(number ? fmt::format("{}", *number) : "");
        fields.insert(fields.end(), row.texts.begin(), row.texts.end());
        fields.push_back(row.error);
        text += csv_line(fields);
    }
    return text;
}

}  // namespace aoscore
