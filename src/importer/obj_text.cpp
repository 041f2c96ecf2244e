#include "importer/obj_text.h"

#include "core/error.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace aoscore::importer {
namespace {

constexpr std::string_view kBlank = " \t\r\f\v";

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(kBlank);
    if (first == line.npos) return {};
    return line.substr(first, line.find_last_not_of(kBlank) - first + 1);
}

/// The rest of a statement that begins with the keyword; empty for another statement.
std::string_view arguments_of(std::string_view statement, std::string_view keyword) {
    if (!statement.starts_with(keyword) || statement.size() <= keyword.size()) return {};
    if (kBlank.find(statement[keyword.size()]) == kBlank.npos) return {};
    return trimmed(statement.substr(keyword.size()));
}

/// The characters allowed in a statement whose numbers must be right; empty for another statement. A normal
/// that is no number is read as zero, and such normals are repaired later.
std::string_view characters_of(std::string_view statement) {
    if (!arguments_of(statement, "v").empty()) return "0123456789+-.eE \t\r\f\v";
    if (!arguments_of(statement, "f").empty()) return "0123456789+-/ \t\r\f\v";
    return {};
}

void check_numbers(std::string_view statement, std::size_t line) {
    const std::string_view allowed = characters_of(statement);
    const std::string_view numbers =
        statement.substr(std::min(statement.size(), statement.find_first_of(kBlank)));
    if (numbers.find_first_not_of(allowed) == numbers.npos) return;
    throw file_error("holds what is no finite number: " + gltf::printable(statement),
                     fmt::format("line {}", line), "decimal numbers");
}

/// The statements of a text, one after the other, each as the part of it that may be overwritten.
class Statements {
  public:
    explicit Statements(std::string& text) : text_(text) {}

    std::size_t line() const { return line_; }  ///< the last line of the statement, counted from 1

    /// The next statement, with blanks in place of the line ends that continue it; nothing at the end of the
    /// text.
    std::optional<std::span<char>> next() {
        if (at_ >= text_.size()) return std::nullopt;
        const std::size_t start = at_;
        std::size_t end = end_of_line(start);
        while (end < text_.size() && goes_on(start, end)) end = end_of_line(end);
        at_ = end + 1;
        return std::span(text_).subspan(start, end - start);
    }

  private:
    std::size_t end_of_line(std::size_t from) {
        ++line_;
        return std::min(text_.size(), text_.find('\n', from));
    }
    bool goes_on(std::size_t start, std::size_t end) {
        const std::size_t first = text_.find_first_not_of(kBlank, start);
        if (end == start || text_[first] == '#') return false;
        const std::size_t last = text_.find_last_not_of(kBlank, end - 1);
        if (last == text_.npos || last < start || text_[last] != '\\') return false;
        std::fill(text_.begin() + static_cast<long>(last), text_.begin() + static_cast<long>(end) + 1, ' ');
        return true;
    }

    std::string& text_;
    std::size_t at_ = 0, line_ = 0;
};

void blank(std::span<char> part) {
    std::fill(part.begin(), part.end(), ' ');
}

void refuse_utf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw file_error("is UTF-16", "line 1", "UTF-8 or another text of single bytes");
}

}  // namespace

ObjText prepare_obj(std::string text) {
    refuse_utf16(text);
    if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, 3, ' ');
    std::replace(text.begin(), text.end(), '\0', ' ');
    ObjText result;
    Statements statements(text);
    while (const std::optional<std::span<char>> part = statements.next()) {
        std::string_view statement = trimmed({part->data(), part->size()});
        if (!characters_of(statement).empty()) {
            const std::size_t comment = std::string_view(part->data(), part->size()).find('#');
            if (comment != std::string_view::npos) blank(part->subspan(comment));
            statement = trimmed({part->data(), part->size()});
            check_numbers(statement, statements.line());
        } else if (const std::string_view library = arguments_of(statement, "mtllib"); !library.empty()) {
            result.libraries.emplace_back(library);
            blank(*part);
        } else if (statement.starts_with("curv") || statement.starts_with("surf")) {
            ++result.curves;
        }
    }
    result.statements = std::move(text);
    return result;
}

}  // namespace aoscore::importer
