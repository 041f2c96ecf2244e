#include "core/counted.h"
#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/cost_chart.h"
#include "page/sections/listing.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

json front_model(const CostChart& chart) {
    json front = json::array();
    for (const CostPoint& point : chart.points) {
        if (!point.front) continue;
        front.push_back({{"method", shown_name(*point.cell)},
                         {"preset", point.cell->preset},
                         {"ms", fixed_text(point.ms, 2)},
                         {"error", fixed_text(point.error, 4)}});
    }
    return front;
}

/// Says which methods are on the front of a view.
std::string front_sentence(const CostChart& chart, const std::string& view_key) {
    const std::vector<std::string> names = front_names(chart);
    const auto in_use = std::ranges::count_if(
        chart.points, [](const CostPoint& point) { return point.cell->role != kBoundRole; });
    if (names.empty()) return fmt::format("On {} only bounds have both a time and an error.", view_key);
    const std::string all = counted(static_cast<std::size_t>(in_use), "method", "methods");
    if (in_use == 1)
        return fmt::format("On {}, {} is the only method with both a time and an error.", view_key, names[0]);
    if (names.size() == 1)
        return fmt::format("On {}, {} is the fastest and closest of {}.", view_key, names[0], all);
    return fmt::format("On {}, no method beats these {} of {} in both time and error: {}.", view_key,
                       names.size(), all, fmt::join(names, "; "));
}

}  // namespace

json section::cost(const PageSource& source) {
    json model = {{"charts", json::array()}, {"in_short", "No method has both a time and an error."}};
    for (const ViewRecord& view : source.results.views) {
        const CostChart chart = cost_chart(source.results, view);
        if (chart.points.empty()) continue;
        if (model["charts"].empty()) model["in_short"] = front_sentence(chart, view.key);
        model["charts"].push_back({{"view", view.key},
                                   {"metric", std::string(metric(chart.metric).in_text)},
                                   {"data", chart.data},
                                   {"front", front_model(chart)}});
    }
    return model;
}

}  // namespace aoscore
