#include "core/printable.h"
#include "results/export/export_format.h"
#include "results/export/reader_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    ReaderTable shown(table, {latex_escaped, number});
    shown.align();
    std::string alignment;
    for (const bool is_number : shown.is_number) alignment += is_number ? 'r' : 'l';
    std::string text = fmt::format("% {}\n", latex_escaped(table.title));
    for (const std::string& note : table.notes) text += fmt::format("% {}\n", latex_escaped(note));
    text += fmt::format("% needs \\usepackage{{booktabs}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n",
                        alignment, fmt::join(shown.heads, " & "));
    const std::string* group = nullptr;
    for (std::size_t r = 0; r < shown.rows.size(); ++r) {
        const std::string& first = table.rows[r].names.front();
        if (group == nullptr || *group != first) text += "\\midrule\n";
        group = &first;
        text += fmt::format("{} \\\\\n", fmt::join(shown.rows[r], " & "));
    }
    return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace aoscore
