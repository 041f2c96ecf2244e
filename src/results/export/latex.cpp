#include "core/printable.h"
#include "results/export/export_format.h"

#include <fmt/format.h>

#include <map>

namespace aoscore {
namespace {

std::string latex_escaped(const std::string& text) {
    static const std::map<char, std::string> kSpecial = {{'&', "\\&"},
                                                         {'%', "\\%"},
                                                         {'$', "\\$"},
                                                         {'#', "\\#"},
                                                         {'_', "\\_"},
                                                         {'{', "\\{"},
                                                         {'}', "\\}"},
                                                         {'~', "\\textasciitilde{}"},
                                                         {'^', "\\textasciicircum{}"},
                                                         {'\\', "\\textbackslash{}"},
                                                         {'\n', " "}};
    std::string result;
    for (const char c : printable_lines(text)) {
        const auto found = kSpecial.find(c);
        result += found == kSpecial.end() ? std::string(1, c) : found->second;
    }
    return result;
}

std::string number(const std::optional<double>& value, int decimals) {
    if (!value) return "--";
    const std::string text = brief_number(value, decimals);
    return text.starts_with('-') ? "$" + text + "$" : text;
}

}  // namespace

std::string export_as::latex(const ExportTable& table) {
    std::string alignment(table.name_columns.size(), 'l'), head;
    for (const std::string& name : table.name_columns)
        head += (head.empty() ? "" : " & ") + latex_escaped(name);
    for (const ExportColumn& column : table.columns) {
        if (!column.brief) continue;
        alignment += 'r';
        head += " & " + latex_escaped(column.label);
    }
    std::string text = fmt::format("% {}\n", latex_escaped(table.title));
    for (const std::string& note : table.notes) text += fmt::format("% {}\n", latex_escaped(note));
    text += fmt::format("% needs \\usepackage{{booktabs}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n",
                        alignment, head);
    const std::string* group = nullptr;
    for (const ExportRow& row : table.rows) {
        if (group == nullptr || *group != row.names.front()) text += "\\midrule\n";
        group = &row.names.front();
        for (std::size_t i = 0; i < row.names.size(); ++i)
            text += (i > 0 ? " & " : "") + latex_escaped(row.names[i]);
        for (std::size_t i = 0; i < row.numbers.size(); ++i) {
            if (table.columns[i].brief) text += " & " + number(row.numbers[i], table.columns[i].decimals);
        }
        text += " \\\\\n";
    }
    return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace aoscore
