#include "page/sections/cost_chart.h"

#include "metrics/pareto.h"
#include "page/document/page_template.h"
#include "page/section.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;

std::vector<CostPoint> points_of(const Results& results, const ViewRecord& view, const std::string& metric) {
    std::vector<CostPoint> points;
    for (const CellRecord& cell : results.cells) {
        const auto ms = cost_ms(cell);
        const auto error = ranked_value(cell, metric);
        if (cell.view_key == view.key && ms && error) points.push_back({&cell, *ms, *error});
    }
    std::ranges::stable_sort(points, {},
                             [](const CostPoint& point) { return std::pair(point.ms, point.error); });
    std::vector<CostAndError> in_use;
    for (const CostPoint& point : points) {
        const bool bound = point.cell->role == kBoundRole;
        in_use.push_back(bound ? CostAndError{} : CostAndError{point.ms, point.error});
    }
    const std::vector<bool> front = pareto_front(in_use);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].front = front[i];
    return points;
}

json chart_data(const std::vector<CostPoint>& points, const std::string& metric) {
    json list = json::array();
    for (const CostPoint& point : points) {
        const double spread =
            point.cell->ao.spread_ms.value_or(0) + point.cell->filter_pass.spread_ms.value_or(0);
        list.push_back({{"label", shown_name(*point.cell)},
                        {"preset", point.cell->preset},
                        {"cell", point.cell->id},
                        {"bound", point.cell->role == kBoundRole},
                        {"ms", point.ms},
                        {"spread", spread},
                        {"error", point.error},
                        {"front", point.front}});
        if (!point.cell->analysis) continue;
        const auto& intervals = point.cell->analysis->intervals;
        if (const auto found = intervals.find(metric); found != intervals.end()) {
            list.back()["low"] = found->second.low;
            list.back()["high"] = found->second.high;
        }
    }
    return list;
}

}  // namespace

CostChart cost_chart(const Results& results, const ViewRecord& view) {
    std::vector<const CellRecord*> cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key) cells.push_back(&cell);
    }
    CostChart chart{ranking_metric(cells), {}, {}};
    chart.points = points_of(results, view, chart.metric);
    chart.data = script_json(chart_data(chart.points, chart.metric));
    return chart;
}

std::vector<std::string> front_names(const CostChart& chart) {
    std::vector<std::string> names;
    for (const CostPoint& point : chart.points) {
        if (point.front) names.push_back(fmt::format("{}, {}", shown_name(*point.cell), point.cell->preset));
    }
    return names;
}

}  // namespace aoscore
