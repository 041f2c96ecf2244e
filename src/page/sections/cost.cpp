#include "metrics/evaluate.h"
#include "metrics/pareto.h"
#include "page/document/number_text.h"
#include "page/document/page_template.h"
#include "page/section.h"
#include "results/ranked_value.h"

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;

/// A cell that has both a cost and an error.
struct Point {
    const CellRecord* cell;
    double ms, error;
    bool front = false;  ///< never true for a bound, which is not for use
};

std::vector<Point> points_of(const Results& results, const ViewRecord& view, const std::string& metric) {
    std::vector<Point> points;
    for (const CellRecord& cell : results.cells) {
        const auto ms = cost_ms(cell);
        const auto error = ranked_value(cell, metric);
        if (cell.view_key == view.key && ms && error) points.push_back({&cell, *ms, *error});
    }
    std::ranges::stable_sort(points, {}, [](const Point& point) { return std::pair(point.ms, point.error); });
    std::vector<CostAndError> in_use;
    for (const Point& point : points) {
        const bool bound = point.cell->role == kBoundRole;
        in_use.push_back(bound ? CostAndError{} : CostAndError{point.ms, point.error});
    }
    const std::vector<bool> front = pareto_front(in_use);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].front = front[i];
    return points;
}

json chart_data(const std::vector<Point>& points, const std::string& metric) {
    json list = json::array();
    for (const Point& point : points) {
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

nlohmann::json section::cost(const PageSource& source) {
    json model = {{"charts", json::array()}};
    for (const ViewRecord& view : source.results.views) {
        std::vector<const CellRecord*> cells;
        for (const CellRecord& cell : source.results.cells) {
            if (cell.view_key == view.key) cells.push_back(&cell);
        }
        const std::string metric = ranking_metric(cells);
        const std::vector<Point> points = points_of(source.results, view, metric);
        if (points.empty()) continue;
        json front = json::array();
        for (const Point& point : points) {
            if (!point.front) continue;
            front.push_back({{"method", shown_name(*point.cell)},
                             {"preset", point.cell->preset},
                             {"ms", fixed_text(point.ms, 2)},
                             {"error", fixed_text(point.error, 4)}});
        }
        model["charts"].push_back({{"view", view.key},
                                   {"metric", std::string(aoscore::metric(metric).in_text)},
                                   {"data", script_json(chart_data(points, metric))},
                                   {"front", std::move(front)}});
    }
    model["has_charts"] = !model["charts"].empty();
    return model;
}

}  // namespace aoscore
