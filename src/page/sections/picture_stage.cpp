#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/stage_data.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;

/// The cell that is shown first on a view: the one with the least error, a bound only without others; empty
/// without any.
std::string first_shown(const Results& results, const std::string& view_key) {
    std::vector<const CellRecord*> cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view_key) cells.push_back(&cell);
    }
    const std::string metric = ranking_metric(cells);
    const auto order = [&](const CellRecord* cell) {
        return std::pair(cell->role == kBoundRole, *ranked_value(*cell, metric));
    };
    const CellRecord* closest = nullptr;
    for (const CellRecord* cell : cells) {
        if (ranked_value(*cell, metric) && (closest == nullptr || order(cell) < order(closest)))
            closest = cell;
    }
    return closest != nullptr ? closest->id : "";
}

json chooser_of_cells(const Results& results, const ViewRecord& view) {
    json cells = json::array();
    const std::string opened = first_shown(results, view.key);
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key != view.key) continue;
        const std::size_t number = cells.size() + 1;
        cells.push_back({{"id", cell.id},
                         {"method", shown_name(cell)},
                         {"preset", cell.preset},
                         {"number", std::to_string(number)},
                         {"has_key", number <= 9},
                         {"checked", cell.id == opened},
                         {"failed", !cell.error.empty()},
                         {"error", cell.error}});
    }
    return cells;
}

}  // namespace

nlohmann::json section::pictures(const PageSource& source) {
    json views = json::array();
    for (const ViewRecord& view : source.results.views) {
        views.push_back({{"key", view.key},
                         {"checked", views.empty()},
                         {"width", std::to_string(view.width)},
                         {"height", std::to_string(view.height)},
                         {"cells", chooser_of_cells(source.results, view)}});
    }
    return {{"views", std::move(views)}};
}

}  // namespace aoscore
