#include "core/known_names.h"
#include "metrics/analysis/fit_range.h"
#include "metrics/roles.h"
#include "page/document/number_text.h"
#include "page/document/page_template.h"
#include "page/section.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace aoscore {
namespace {

using nlohmann::json;
using Cells = std::vector<const CellRecord*>;

Cells analysed_cells(const Results& results, const ViewRecord& view) {
    Cells cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key && cell.analysis) cells.push_back(&cell);
    }
    return cells;
}

/// The name of a curve, with the preset where a view has several.
std::string series_name(const CellRecord& cell, const Cells& cells) {
    const bool one_preset =
        std::ranges::all_of(cells, [&](const CellRecord* other) { return other->preset == cell.preset; });
    return one_preset ? shown_name(cell) : fmt::format("{}, {}", shown_name(cell), cell.preset);
}

/// The data of a chart: the middles of bins, and the shares of each method at them.
json curves_data(const Cells& cells, bool cumulative) {
    json series = json::array();
    for (const CellRecord* cell : cells) {
        const ErrorDistribution& spread = cell->analysis->distribution;
        series.push_back({{"name", series_name(*cell, cells)},
                          {"shares", cumulative ? spread.cumulative : spread.histogram}});
    }
    const ErrorDistribution& first = cells.front()->analysis->distribution;
    const auto bins = static_cast<double>(first.histogram.size());
    const double bin = (first.histogram_high - first.histogram_low) / bins;
    return {{"low", cumulative ? 0.0 : first.histogram_low + bin / 2},
            {"step", cumulative ? first.cumulative_step : bin},
            {"series", std::move(series)}};
}

constexpr std::string_view kSignSplit = "sign";

/// The parameter's number, with a remark where the search ended at a bound of its range.
std::string fitted_text(double value, const FitRange& range) {
    const double near = 0.001;
    const bool at_bound = value < range.least + near || value > range.most - near;
    return fixed_text(value, 2) + (at_bound ? ", the end of the range" : "");
}

json fit_row(const CellRecord& cell, const Cells& cells) {
    const BestFit& fit = cell.analysis->fit;
    const auto before = value_of(cell.ranked, fit.rmse_debiased ? kRankingMetric : kNoisyRankingMetric);
    const double after = fit.rmse_debiased.value_or(fit.rmse);
    const auto gain = before ? ratio(*before - after, *before) : std::nullopt;
    return {
        {"method", series_name(cell, cells)},
        {"cell", cell.id},
        {"numbers",
         json::array(
             {{{"text", fitted_text(fit.strength, kFitStrengths)}, {"sort", fmt::format("{}", fit.strength)}},
              {{"text", fitted_text(fit.exponent, kFitExponents)}, {"sort", fmt::format("{}", fit.exponent)}},
              {{"text", fixed_text(before, 4)}, {"sort", before ? fmt::format("{}", *before) : ""}},
              {{"text", fixed_text(after, 4)}, {"sort", fmt::format("{}", after)}},
              {{"text", percent_text(gain, 0)}, {"sort", gain ? fmt::format("{}", *gain) : ""}}})}};
}

json bin_model(const SplitBin& bin, double largest) {
    const double part = bin.rmse && largest > 0 ? *bin.rmse / largest : 0;
    return {{"text", fixed_text(bin.rmse, 4)},
            {"sort", bin.rmse ? fmt::format("{}", *bin.rmse) : std::string()},
            {"width", fmt::format("{:.1f}%", part * 100)},
            {"note",
             fmt::format("{} % of the pixels, {} % of the squared error, bias {}", percent_text(bin.share, 1),
                         percent_text(bin.error_share, 1), fixed_text(bin.bias, 4))}};
}

const Split* split_of(const CellRecord& cell, const std::string& id) {
    return find_row(cell.analysis->splits, id);
}

/// A bin's share of the pixels, where it is the same for all methods.
std::string common_share(const std::string& split, std::size_t bin, const Cells& cells) {
    std::optional<std::string> common;
    for (const CellRecord* cell : cells) {
        const Split* own = split_of(*cell, split);
        if (own == nullptr || bin >= own->bins.size()) return "";
        const std::string share = percent_text(own->bins[bin].share, 1);
        if (common.value_or(share) != share) return "";
        common = share;
    }
    return common.value_or("") + " %";
}

/// The bins that hold pixels of some method; the others would be columns of dashes.
std::vector<std::size_t> filled_bins(const Split& split, const Cells& cells) {
    std::vector<std::size_t> filled;
    for (std::size_t i = 0; i < split.bins.size(); ++i) {
        const bool any = std::ranges::any_of(cells, [&](const CellRecord* cell) {
            const Split* own = split_of(*cell, split.id);
            return own != nullptr && i < own->bins.size() && own->bins[i].share > 0;
        });
        if (any) filled.push_back(i);
    }
    return filled;
}

/// The model of one split of all methods, which have the same bins.
json split_model(const Split& split, const Cells& cells) {
    const std::vector<std::size_t> shown = filled_bins(split, cells);
    double largest = 0;
    json heads = json::array(), rows = json::array();
    for (const std::size_t i : shown)
        heads.push_back({{"label", split.bins[i].label}, {"share", common_share(split.id, i, cells)}});
    for (const CellRecord* cell : cells) {
        const Split* own = split_of(*cell, split.id);
        for (const SplitBin& bin : own != nullptr ? own->bins : split.bins)
            largest = std::max(largest, bin.rmse.value_or(0));
    }
    for (const CellRecord* cell : cells) {
        const Split* own = split_of(*cell, split.id);
        if (own == nullptr || own->bins.size() != split.bins.size()) continue;
        json bins = json::array();
        for (const std::size_t i : shown) bins.push_back(bin_model(own->bins[i], largest));
        rows.push_back({{"method", series_name(*cell, cells)}, {"bins", std::move(bins)}});
    }
    return {{"label", split.label},
            {"unit", split.unit},
            {"meaning", split.meaning},
            {"heads", std::move(heads)},
            {"rows", std::move(rows)}};
}

json view_model(const ViewRecord& view, const Cells& cells) {
    json fits = json::array(), splits = json::array();
    for (const CellRecord* cell : cells) fits.push_back(fit_row(*cell, cells));
    for (const Split& split : cells.front()->analysis->splits) splits.push_back(split_model(split, cells));
    return {{"key", view.key},
            {"histogram", script_json(curves_data(cells, false))},
            {"cumulative", script_json(curves_data(cells, true))},
            {"fits", std::move(fits)},
            {"splits", std::move(splits)}};
}

/// Names the part of the picture whose share of the squared error exceeds its share of the pixels most, for
/// the first method of the first view. The sign of the error is no part of the picture that one could mend.
std::string detail_in_short(const Results& results) {
    const auto found = std::ranges::find_if(results.cells, [](const CellRecord& cell) {
        return cell.analysis.has_value() && cell.role != kBoundRole;
    });
    if (found == results.cells.end()) return "Only bounds were analysed.";
    const Split* split = nullptr;
    const SplitBin* worst = nullptr;
    for (const Split& one : found->analysis->splits) {
        for (const SplitBin& bin : one.bins) {
            const bool more =
                worst == nullptr || bin.error_share - bin.share > worst->error_share - worst->share;
            if (one.id == kSignSplit || !more) continue;
            split = &one;
            worst = &bin;
        }
    }
    if (worst == nullptr) return "No part of a picture was analysed.";
    const std::string unit = split->unit.empty() ? "" : " " + split->unit;
    return fmt::format("On {}, {} % of the squared error of {} lies in {} % of the pixels ({}: {}{}).",
                       found->view_key, percent_text(worst->error_share, 0), shown_name(*found),
                       percent_text(worst->share, 0), split->label, worst->label, unit);
}

}  // namespace

nlohmann::json section::distributions(const PageSource& source) {
    json model = {{"views", json::array()}, {"in_short", detail_in_short(source.results)}};
    for (const ViewRecord& view : source.results.views) {
        const Cells cells = analysed_cells(source.results, view);
        if (!cells.empty()) model["views"].push_back(view_model(view, cells));
    }
    return model;
}

}  // namespace aoscore
