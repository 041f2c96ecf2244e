#include "results/lengths_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

std::string origin_text(const std::string& origin) {
    constexpr std::array kTexts{std::pair{LengthRecord::kOwn, "the descriptor's own"},
                                std::pair{LengthRecord::kPreset, "fixed by the preset"},
                                std::pair{LengthRecord::kSet, "set"}};
    for (const auto& [id, text] : kTexts) {
        if (origin == id) return fmt::format(" ({})", text);
    }
    return {};
}

}  // namespace

std::string lengths_text(const CellRecord& cell) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < cell.lengths.size(); ++i) {
        const LengthRecord& length = cell.lengths[i];
        const bool last_of_origin =
            i + 1 == cell.lengths.size() || cell.lengths[i + 1].origin != length.origin;
        parts.push_back(fmt::format("{} {:.4g} {}{}", length.id, length.value, length.unit,
                                    last_of_origin ? origin_text(length.origin) : ""));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string radius_text(const ViewRecord& view) {
    return fmt::format("R {:.4g} m ({}), {:.1f} pixels in the median", view.radius_m, view.radius_rule,
                       view.radius_px_median);
}

}  // namespace aoscore
