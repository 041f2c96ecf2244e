#include "results/results.h"

#include <fmt/format.h>

namespace aoscore {

std::string shown_name(const CellRecord& cell) {
    return cell.setting.empty() ? cell.method_label : cell.method_label + ", " + cell.setting;
}

std::string rank_text(const PlaceRecord& place) {
    if (!place.rank) return kBoundRole;
    const auto [best, worst] = *place.rank;
    return best == worst ? fmt::format("{}", best) : fmt::format("{}–{}", best, worst);
}

}  // namespace aoscore
