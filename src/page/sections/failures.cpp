#include "core/known_names.h"
#include "page/document/number_text.h"
#include "page/document/stage_link.h"
#include "page/section.h"
#include "page/sections/causes.h"
#include "results/view_piece.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

/// The number of regions of each mask that are shown at first; the results list more.
constexpr std::size_t kShownOfEach = 3;

std::string css_percent(double share) {
    return fmt::format("{:.2f}%", share * 100);
}

double area_of(const MaskSummary& mask, const std::string& cause) {
    const auto found = find_row(mask.causes, cause, &CauseShare::cause);
    return found == nullptr ? 0.0 : found->area;
}

/// The 95 % interval of a mask's mean error in words.
std::string mean_interval(const ErrorAnalysis& analysis, const MaskArea& area) {
    if (!area.mean(analysis)) return "";
    const auto found = analysis.intervals.find(std::string(area.mean_id));
    if (found == analysis.intervals.end()) return kNoInterval;
    return fmt::format("{} to {}", fixed_text(found->second.low, 3), fixed_text(found->second.high, 3));
}

/// The parts of one method's bar; the whole mask where causes are not known.
json bar_parts(const MaskSummary& mask, double widest) {
    json parts = json::array();
    const auto add = [&](const std::string& id, double area) {
        parts.push_back({{"cause", id}, {"width", css_percent(widest > 0 ? area / widest : 0)}});
    };
    if (mask.causes.empty()) {
        add("unknown", mask.area);
    } else {
        for (const CauseText& cause : causes()) add(cause.id, area_of(mask, cause.id));
    }
    return parts;
}

json row_model(const CellRecord& cell, double widest) {
    const ErrorAnalysis& analysis = *cell.analysis;
    json shares = json::array();
    for (const CauseText& cause : causes()) {
        const bool known = !analysis.missing.causes.empty();
        const double area = area_of(analysis.missing, cause.id);
        shares.push_back({{"text", known ? percent_text(area) : std::string(kNoNumber)},
                          {"sort", known ? fmt::format("{}", area) : std::string()}});
    }
    return {{"method", shown_name(cell)},
            {"cell", cell.id},
            {"preset", cell.preset},
            {"missing", percent_text(analysis.missing.area)},
            {"missing_sort", fmt::format("{}", analysis.missing.area)},
            {"missing_mean", fixed_text(analysis.missing.mean, 3)},
            {"missing_mean_interval", mean_interval(analysis, mask_areas()[0])},
            {"parts", bar_parts(analysis.missing, widest)},
            {"shares", std::move(shares)},
            {"false", percent_text(analysis.false_occlusion.area)},
            {"false_sort", fmt::format("{}", analysis.false_occlusion.area)},
            {"false_mean", fixed_text(analysis.false_occlusion.mean, 3)},
            {"false_mean_interval", mean_interval(analysis, mask_areas()[1])},
            {"false_width", css_percent(widest > 0 ? analysis.false_occlusion.area / widest : 0)}};
}

/// A view of the region and as much around it, as an entry of a view file.
std::string crop_text(const ViewRecord& view, const ErrorRegion& region) {
    const PictureBox box{region.left - region.width / 2, region.top - region.height / 2, 2 * region.width,
                         2 * region.height};
    return crop_piece(view, box, fmt::format("{}_at_{}_{}", view.view, region.left, region.top)).dump();
}

json region_model(const ViewRecord& view, const CellRecord& cell, const ErrorRegion& region) {
    const std::string cause = cause_label(region.cause);
    const std::string box = fmt::format("{},{},{},{}", region.left, region.top, region.width, region.height);
    return {{"kind", region.kind == "missing" ? "missing" : "false"},
            {"view", cell.view_key},
            {"cell", cell.id},
            {"box", box},
            {"link", stage_link({{"view", cell.view_key},
                                 {"cell", cell.id},
                                 {"picture", "error"},
                                 {"mode", "beside"},
                                 {"at", box}})},
            {"place", fmt::format("{}, {}", region.left + region.width / 2, region.top + region.height / 2)},
            {"mean", (region.mean_error > 0 ? "+" : "") + fixed_text(region.mean_error, 2)},
            {"area", count_text(region.area_px)},
            {"has_cause", !cause.empty()},
            {"cause", cause},
            {"crop", crop_text(view, region)}};
}

json regions_model(const ViewRecord& view, const CellRecord& cell) {
    json regions = json::array();
    std::size_t missing = 0, others = 0;
    for (const ErrorRegion& region : cell.analysis->regions) {
        std::size_t& shown = region.kind == "missing" ? missing : others;
        if (++shown <= kShownOfEach) regions.push_back(region_model(view, cell, region));
    }
    return regions;
}

json view_model(const ViewRecord& view, const PageSource& source) {
    const Results& results = source.results;
    std::vector<const CellRecord*> cells;
    double widest = 0;
    bool causes_known = false;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key != view.key || !cell.analysis) continue;
        cells.push_back(&cell);
        widest = std::max({widest, cell.analysis->missing.area, cell.analysis->false_occlusion.area});
        causes_known = causes_known || !cell.analysis->missing.causes.empty();
    }
    json rows = json::array(), methods = json::array();
    for (const CellRecord* cell : cells) {
        rows.push_back(row_model(*cell, widest));
        if (!source.pictures.cells.contains(cell->id)) continue;
        json regions = regions_model(view, *cell);
        if (regions.empty()) continue;
        methods.push_back({{"method", shown_name(*cell)},
                           {"preset", cell->preset},
                           {"open", methods.empty()},
                           {"regions", std::move(regions)}});
    }
    return {{"key", view.key},
            {"rows", std::move(rows)},
            {"causes_known", causes_known},
            {"has_regions", !methods.empty()},
            {"methods", std::move(methods)}};
}

/// Says where the first method of the first view fails, and for which cause most of all.
std::string failures_in_short(const Results& results) {
    const auto found = std::ranges::find_if(results.cells, [](const CellRecord& cell) {
        return cell.analysis.has_value() && cell.role != kBoundRole;
    });
    if (found == results.cells.end()) return "Only bounds were analysed.";
    const MaskSummary& missing = found->analysis->missing;
    std::string cause;
    if (!missing.causes.empty()) {
        const auto most = std::ranges::max_element(missing.causes, {}, &CauseShare::area);
        if (most->area > 0)
            cause = fmt::format(", mostly where the occluder is {}", cause_label(most->cause));
    }
    return fmt::format("On {} {} misses occlusion on {} % of the pixels{}, and adds false occlusion on {} %.",
                       found->view_key, shown_name(*found), percent_text(missing.area, 1), cause,
                       percent_text(found->analysis->false_occlusion.area, 1));
}

}  // namespace

nlohmann::json section::failures(const PageSource& source) {
    json model = {{"views", json::array()},
                  {"causes", json::array()},
                  {"in_short", failures_in_short(source.results)},
                  {"threshold", short_text(source.results.mask_threshold)}};
    for (const CauseText& cause : causes()) {
        model["causes"].push_back({{"id", cause.id}, {"label", cause.label}, {"meaning", cause.meaning}});
    }
    for (const ViewRecord& view : source.results.views) model["views"].push_back(view_model(view, source));
    return model;
}

}  // namespace aoscore
