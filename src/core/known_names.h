#pragma once

#include "core/error.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {

/// Finds the known name that a mistyped one most likely meant: the nearest by letters that were left out,
/// added, exchanged or swapped (optimal string alignment), when they are at most a third of the letters; else
/// the only one that it begins, or that it is part of. Case does not count.
std::optional<std::string> meant_name(std::string_view name, const std::vector<std::string>& known);

/// `<what> "gtoa"; did you mean gtao?`, or without the question where nothing is near. `what` such as "no
/// method" or "has no channel".
std::string unknown_name_text(std::string_view what, std::string_view name,
                              const std::vector<std::string>& known);

/// A usage error of that text. It lists the known names as valid, followed by `or_else`.
Error unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& known,
                   std::string where = {}, std::string_view or_else = {});

/// A file error: the name at `where` is none of the known names, which it lists.
Error unknown_name_in_file(std::string_view name, const std::vector<std::string>& known, std::string where);

/// The ids of a table's rows, for unknown_name().
template <class Rows>
std::vector<std::string> ids_of(const Rows& rows) {
    std::vector<std::string> ids;
    for (const auto& row : rows) ids.emplace_back(row.id);
    return ids;
}

/// The first row whose `member` is `name`; null where none is.
template <class Rows, class Member>
auto find_row(Rows& rows, std::string_view name, Member member) {
    const auto found = std::ranges::find_if(
        rows, [&](const auto& row) { return std::string_view(std::invoke(member, row)) == name; });
    return found == std::ranges::end(rows) ? nullptr : &*found;
}

/// The row of this id; null where there is none.
template <class Rows>
auto find_row(Rows& rows, std::string_view id) {
    return find_row(rows, id, [](const auto& row) { return std::string_view(row.id); });
}

/// The row of an id that the user chose. Throws unknown_name() where there is none, listing all ids.
template <class Rows>
auto& row_of(Rows& rows, std::string_view id, std::string_view what, std::string where = {}) {
    if (const auto row = find_row(rows, id)) return *row;
    throw unknown_name(what, id, ids_of(rows), std::move(where));
}

/// The row of an id that stands in a file, at `where`. Throws unknown_name_in_file() where there is none.
template <class Rows>
auto& row_in_file(Rows& rows, std::string_view id, std::string where) {
    if (const auto row = find_row(rows, id)) return *row;
    throw unknown_name_in_file(id, ids_of(rows), std::move(where));
}

}  // namespace aoscore
