#include "page/sections/interval_tables.h"

#include "page/document/number_text.h"
#include "page/sections/ranking_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {
namespace {

using nlohmann::json;

/// A measure's heading and format.
struct Head {
    std::string id, label, unit;
    double scale;
    int decimals;
    int keep;  ///< as RankingColumn has it
};

std::vector<Head> heads() {
    std::vector<Head> list;
    for (const Metric& metric : metrics()) {
        list.push_back({std::string(metric.id), std::string(metric.label), std::string(metric.unit), 1,
                        metric.decimals, metric_keep(metric.id)});
    }
    for (const MaskArea& area : mask_areas())
        list.push_back({std::string(area.id), std::string(area.label), "%", 100, 2, kKeepAreas});
    return list;
}

json number_model(const PlaceRecord& place, const Head& head) {
    const auto found = place.measures.find(head.id);
    if (found == place.measures.end()) return {{"text", kNoNumber}, {"sort", ""}, {"interval", ""}};
    const MeasureRecord& measure = found->second;
    const auto text = [&](double value) { return fixed_text(value * head.scale, head.decimals); };
    return {{"text", text(measure.value)},
            {"sort", fmt::format("{}", measure.value)},
            {"interval", measure.interval            ? fmt::format("{} to {}", text(measure.interval->low),
                                                                   text(measure.interval->high))
                         : can_be_resampled(head.id) ? kNoInterval
                                                     : ""}};
}

}  // namespace

nlohmann::json interval_tables(const Results& results) {
    json tables = json::array(), columns = json::array();
    for (const Head& head : heads())
        columns.push_back({{"label", head.label}, {"unit", head.unit}, {"keep", std::to_string(head.keep)}});
    for (const RankingRecord& ranking : results.rankings) {
        json rows = json::array();
        for (const PlaceRecord& place : ranking.places) {
            json numbers = json::array();
            for (const Head& head : heads()) numbers.push_back(number_model(place, head));
            rows.push_back({{"method", place.method_label},
                            {"preset", place.preset},
                            {"filter", place.filter},
                            {"numbers", std::move(numbers)}});
        }
        tables.push_back({{"views", fmt::format("{}", fmt::join(ranking.view_keys, ", "))},
                          {"over", ranking.view_keys.size() > 1},
                          {"heads", columns},
                          {"rows", std::move(rows)}});
    }
    return tables;
}

}  // namespace aoscore
