#pragma once

#include "core/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Of the known names the one that a mistyped name most likely meant: the nearest by letters that were left
/// out, added, exchanged or swapped (optimal string alignment), when they are at most a third of the letters;
/// else the only one that it begins, or that it is part of. Case does not count.
std::optional<std::string> meant_name(std::string_view name, const std::vector<std::string>& known);

/// `<what> "gtoa"; did you mean gtao?`, or without the question where nothing is near. `what` such as "no
/// method" or "has no channel".
std::string unknown_name_text(std::string_view what, std::string_view name,
                              const std::vector<std::string>& known);

/// A usage error of that text. Names what is known as valid, and `or_else` behind it.
Error unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& known,
                   std::string where = {}, std::string_view or_else = {});

/// The ids of a table's rows, for unknown_name().
template <class Rows>
std::vector<std::string> ids_of(const Rows& rows) {
    std::vector<std::string> ids;
    for (const auto& row : rows) ids.emplace_back(row.id);
    return ids;
}

}  // namespace aoscore
