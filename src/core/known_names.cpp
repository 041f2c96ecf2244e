#include "core/known_names.h"

#include "core/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

/// Counts the letters to leave out, add, exchange or swap with the next (optimal string alignment distance).
std::size_t edits(const std::string& from, const std::string& to) {
    std::vector<std::size_t> before, last(to.size() + 1), row(to.size() + 1);
    for (std::size_t j = 0; j <= to.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t exchange = from[i - 1] == to[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + exchange});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(last, row);
    }
    return last[to.size()];
}

}  // namespace

std::optional<std::string> meant_name(std::string_view name, const std::vector<std::string>& known) {
    const std::string mistyped = lower_case(name);
    if (mistyped.size() < 2) return std::nullopt;
    const std::string* nearest = nullptr;
    std::size_t fewest = 0;
    for (const std::string& candidate : known) {
        const std::size_t count = edits(mistyped, lower_case(candidate));
        if (3 * count > std::max(mistyped.size(), candidate.size()) && count > 0) continue;
        if (nearest == nullptr || count < fewest) {
            nearest = &candidate;
            fewest = count;
        }
    }
    if (nearest != nullptr) return *nearest;
    for (const bool at_the_beginning : {true, false}) {
        std::vector<const std::string*> longer;
        for (const std::string& candidate : known) {
            const auto at = lower_case(candidate).find(mistyped);
            if (at_the_beginning ? at == 0 : at != std::string::npos) longer.push_back(&candidate);
        }
        if (longer.size() == 1) return *longer.front();
    }
    return std::nullopt;
}

std::string unknown_name_text(std::string_view what, std::string_view name,
                              const std::vector<std::string>& known) {
    const auto meant = meant_name(name, known);
    return fmt::format("{} \"{}\"{}", what, name, meant ? "; did you mean " + *meant + "?" : "");
}

Error unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& known,
                   std::string where, std::string_view or_else) {
    return usage_error(
        unknown_name_text(what, name, known), std::move(where),
        fmt::format("{}{}{}", fmt::join(known, ", "), or_else.empty() || known.empty() ? "" : "; ", or_else));
}

Error unknown_name_in_file(std::string_view name, const std::vector<std::string>& known, std::string where) {
    const auto meant = meant_name(name, known);
    return file_error(fmt::format("is {}{}", name, meant ? "; did you mean " + *meant + "?" : ""),
                      std::move(where), fmt::format("{}", fmt::join(known, ", ")));
}

}  // namespace aoscore
