#include "results/baseline_scope.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

std::string baseline_scope(const Results& results) {
    const auto some = [&](const auto CellRecord::*measures) {
        return std::ranges::any_of(results.cells,
                                   [&](const CellRecord& cell) { return !(cell.*measures).empty(); });
    };
    const bool light = some(&CellRecord::light), signals = some(&CellRecord::signals);
    if (!light && !signals) return "Compared is the error of visibility.";
    return fmt::format(
        "Compared is the error of visibility alone: those of {}{}{} are not held against the earlier "
        "run.",
        light ? "light" : "", light && signals ? " and of " : "", signals ? "bent normals and cones" : "");
}

}  // namespace aoscore
