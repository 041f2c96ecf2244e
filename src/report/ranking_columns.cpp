#include "report/ranking_columns.h"

#include "metrics/metric.h"
#include "report/number_text.h"

namespace aoscore {
namespace {

MeasuredMetric metric_of(const CellRecord& cell, const std::string& id) {
    const auto found = cell.ranked.find(id);
    return found == cell.ranked.end() ? MeasuredMetric{std::nullopt, "not measured"} : found->second;
}

}  // namespace

std::vector<RankingColumn> ranking_columns(const Results& results) {
    std::vector<RankingColumn> list;
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        list.push_back({id, std::string(metric.label), std::string(metric.unit), std::string(metric.meaning),
                        [id](const CellRecord& cell) { return metric_of(cell, id); },
                        metric.unit.empty() ? 4 : 2});
    }
    const auto area = [](MaskSummary ErrorAnalysis::*mask) {
        return [mask](const CellRecord& cell) {
            if (!cell.analysis) return MeasuredMetric{std::nullopt, ""};
            return MeasuredMetric{(*cell.analysis.*mask).area * 100, ""};
        };
    };
    const std::string threshold = short_text(results.mask_threshold);
    list.push_back({"", "Missing", "%",
                    "Valid pixels brighter than the truth by more than " + threshold +
                        " and three standard errors of the truth.",
                    area(&ErrorAnalysis::missing), 2});
    list.push_back({"", "False", "%",
                    "Valid pixels darker than the truth by more than " + threshold +
                        " and three standard errors of the truth.",
                    area(&ErrorAnalysis::false_occlusion), 2});
    list.push_back({"", "Fetches", "a pixel",
                    "Texture reads of the AO pass, counted, mean over valid pixels.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.fetches_per_pixel, ""};
                    },
                    1});
    list.push_back({"", "AO", "ms", "Median of the AO pass.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.ao.median_ms, ""};
                    },
                    std::nullopt});
    list.push_back({"", "Filter", "ms", "Median of the filter after it.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.blur.median_ms, ""};
                    },
                    std::nullopt});
    list.push_back({"", "Frame", "ms", "G-buffer, AO pass and filter together.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.frame_ms, ""};
                    },
                    std::nullopt});
    return list;
}

}  // namespace aoscore
