#include "page/sections/ranking_columns.h"

#include "metrics/metric.h"
#include "metrics/roles.h"
#include "page/document/number_text.h"
#include "results/layer_times.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

MeasuredMetric metric_of(const CellRecord& cell, const std::string& id) {
    const auto found = cell.ranked.find(id);
    return found == cell.ranked.end() ? MeasuredMetric{std::nullopt, "not measured"} : found->second;
}

// What decides between methods stays longest: the error that ranks, its sign and the cost.
constexpr int kKeepRanking = 1, kKeepCost = 2, kKeepLikeness = 4, kKeepTotals = 5, kKeepOthers = 6;

}  // namespace

int metric_keep(std::string_view id) {
    if (id == kRankingMetric) return kKeepRanking;
    if (id == kBiasMetric) return kKeepCost;
    if (id == kStructureMetric || id == kPerceptualMetric) return kKeepLikeness;
    return kKeepOthers;
}

std::vector<RankingColumn> ranking_columns(const Results& results) {
    std::vector<RankingColumn> list;
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        list.push_back({id, std::string(metric.label), std::string(metric.unit), std::string(metric.meaning),
                        [id](const CellRecord& cell) { return metric_of(cell, id); }, metric.decimals,
                        metric_keep(id)});
    }
    for (const MaskArea& area : mask_areas()) {
        list.push_back(
            {"", std::string(area.label), "%",
             fmt::format("Valid pixels {} than the truth by more than {}, without those that the truth's "
                         "noise adds.",
                         area.side, short_text(results.mask_threshold)),
             [value = area.value](const CellRecord& cell) {
                 if (!cell.analysis) return MeasuredMetric{std::nullopt, ""};
                 return MeasuredMetric{value(*cell.analysis) * 100, ""};
             },
             2, kKeepAreas});
    }
    if (std::ranges::any_of(results.cells, reads_layers)) {
        list.push_back(
            {"", "Beyond one layer", "%",
             "Share of the occlusion beyond one depth layer that the image shows, once its strength is "
             "fitted where one layer is enough. An image that is too dark shows some of it by chance: "
             "compare it with the same method over one layer.",
             [](const CellRecord& cell) {
                 if (!cell.analysis || !cell.analysis->found_beyond_layer)
                     return MeasuredMetric{std::nullopt, "nothing is beyond one layer, or not traced"};
                 return MeasuredMetric{*cell.analysis->found_beyond_layer * 100, ""};
             },
             0, kKeepAreas});
    }
    list.push_back({"", "Fetches", "a pixel",
                    "Texture reads of the AO pass, counted, mean over valid pixels.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.fetches_per_pixel, ""};
                    },
                    1, kKeepCost});
    list.push_back({"", "AO", "ms", "Median of the AO pass.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.ao.median_ms, ""};
                    },
                    std::nullopt, kKeepCost});
    list.push_back({"", "Filter", "ms", "Median of the filter after it.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.filter_pass.median_ms, ""};
                    },
                    std::nullopt, kKeepTotals});
    list.push_back({"", "Frame", "ms", "G-buffer, AO pass and filter together.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.frame_ms, ""};
                    },
                    std::nullopt, kKeepTotals});
    return list;
}

}  // namespace aoscore
