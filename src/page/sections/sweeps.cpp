#include "core/counted.h"
#include "core/known_names.h"
#include "core/source_reference.h"
#include "metrics/intervals/median_interval.h"
#include "page/document/number_text.h"
#include "page/document/page_template.h"
#include "page/section.h"
#include "page/sections/claim_texts.h"
#include "page/sections/printed_times.h"
#include "page/sections/sweep_chart.h"
#include "results/comparable_views.h"
#include "results/sweep_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;
using Rows = std::vector<const SweepRow*>;

std::string cost_text(const SweepRow& row, int decimals) {
    if (!row.cost_low_ms) return fixed_text(row.cost_ms, decimals);
    return fmt::format("{} ({} to {})", fixed_text(row.cost_ms, decimals),
                       fixed_text(row.cost_low_ms, decimals), fixed_text(row.cost_high_ms, decimals));
}

std::string megabytes_text(std::optional<double> bytes) {
    if (bytes) *bytes /= 1e6;
    return fixed_text(bytes, 2);
}

json row_model(const SweepRow& row, int decimals) {
    return {{"cell", row.cell->id},
            {"method", row.cell->method_label},
            {"at", point_text(*row.point)},
            {"failed", !row.cell->error.empty()},
            {"reason", row.cell->error},
            {"cost", cost_text(row, decimals)},
            {"cost_sort", row.cost_ms ? fmt::format("{:.6g}", *row.cost_ms) : ""},
            {"relative", fixed_text(row.relative_cost, 2)},
            {"fetches", fixed_text(row.fetches, 1)},
            {"layer_mb", megabytes_text(row.cell->layer_bytes)},
            {"error", fixed_text(row.error, 4)},
            {"noisy", fixed_text(row.noisy_error, 4)},
            {"fitted", fixed_text(row.fitted_error, 4)},
            {"bias", fixed_text(row.bias, 4)},
            {"beyond_layer", percent_text(row.beyond_layer, 1)},
            {"found_of_layers", percent_text(row.found_of_layers, 1)},
            {"noise", fixed_text(row.noise, 4)},
            {"front", row.on_front},
            {"within", row.within_budget.value_or(false)}};
}

std::string with_spread(const Timing& timing, int decimals) {
    return fmt::format("{} ± {}", fixed_text(timing.median_ms, decimals),
                       fixed_text(timing.spread_ms, decimals));
}

/// The passes and rates of frames, one row for each setting whose lighting was timed.
json frame_rows(const Rows& rows) {
    std::vector<std::optional<double>> parts;
    for (const SweepRow* row : rows) {
        if (row->frame) parts.insert(parts.end(), {row->frame->lighting_ms, row->frame->frame_ms});
    }
    const int decimals = column_decimals(parts);
    json list = json::array();
    for (const SweepRow* row : rows) {
        if (!row->frame) continue;
        const FrameRecord& frame = *row->frame;
        const bool filtered = frame.filter_ms > 0;
        list.push_back({{"method", row->cell->method_label},
                        {"at", point_text(*row->point)},
                        {"geometry", fixed_text(frame.geometry_ms, decimals)},
                        {"lighting", row->view != nullptr ? with_spread(row->cell->lighting, decimals)
                                                          : fixed_text(frame.lighting_ms, decimals)},
                        {"lighting_sort", fmt::format("{:.6g}", frame.lighting_ms)},
                        {"both", fixed_text(frame.geometry_lighting_ms, decimals)},
                        {"ao", fixed_text(frame.ao_ms, decimals)},
                        {"filter", filtered ? fixed_text(frame.filter_ms, decimals) : kNoNumber},
                        {"frame", fixed_text(frame.frame_ms, decimals)},
                        {"both_share", percent_text(frame.geometry_lighting_share, 1)},
                        {"ao_share", percent_text(frame.ao_share, 1)},
                        {"filter_share", filtered ? percent_text(frame.filter_share, 1) : kNoNumber},
                        {"without_ao", fixed_text(frame.per_second_without_ao, 2)},
                        {"with_ao", fixed_text(frame.per_second_unfiltered, 2)},
                        {"with_filter", filtered ? fixed_text(frame.per_second, 2) : kNoNumber}});
    }
    return list;
}

std::string setting(const SweepRow& row) {
    return fmt::format("{} ({})", row.cell->method_label, point_text(*row.point));
}

/// Whether it is known what the setting finds of that which one depth layer hides.
bool has_finding(const SweepRow* row) {
    return row->beyond_layer || row->found_of_layers;
}

/// Whether one setting is closer than another, or as close, and in less time, as far as the intervals of the
/// times tell. Without intervals the times count as they are.
bool beats_for_sure(const SweepRow& one, const SweepRow& other) {
    return *one.error <= *other.error &&
           one.cost_high_ms.value_or(*one.cost_ms) < other.cost_low_ms.value_or(*other.cost_ms);
}

/// The settings off the front that none beats for sure.
Rows maybe_on_front(const Rows& rows) {
    Rows measured, list;
    std::ranges::copy_if(rows, std::back_inserter(measured), [](const SweepRow* row) {
        return row->cost_ms && row->error && row->cell->role != kBoundRole;
    });
    std::ranges::copy_if(measured, std::back_inserter(list), [&](const SweepRow* row) {
        return !row->on_front && std::ranges::none_of(measured, [&](const SweepRow* other) {
            return beats_for_sure(*other, *row);
        });
    });
    return list;
}

/// Says which settings' times are too close to those of the front to be told apart; empty where none are.
std::string untold_text(const Rows& rows) {
    constexpr std::size_t kNamed = 4;
    const Rows maybe = maybe_on_front(rows);
    if (maybe.empty()) return {};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(kNamed, maybe.size()); ++i) names.push_back(setting(*maybe[i]));
    if (maybe.size() > kNamed) names.push_back(fmt::format("{} more", maybe.size() - kNamed));
    return fmt::format(" By the intervals of the times, {} cannot be told apart from these: {}.",
                       maybe.size() == 1 ? "one setting" : fmt::format("{} settings", maybe.size()),
                       fmt::join(names, "; "));
}

/// The leading settings in a sentence or two.
std::string answer(const Rows& rows, std::optional<double> budget_ms) {
    Rows front;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(front),
                 [](const SweepRow* r) { return r->on_front; });
    if (front.empty()) {
        return std::ranges::any_of(rows, [](const SweepRow* row) { return row->error.has_value(); })
                   ? "Errors were measured and no times, so that no setting is the best for its time."
                   : "Nothing could be measured.";
    }
    std::sort(front.begin(), front.end(),
              [](const SweepRow* a, const SweepRow* b) { return *a->cost_ms < *b->cost_ms; });
    std::vector<std::string> names;
    for (const SweepRow* row : front) {
        names.push_back(fmt::format("{} at {} ms with {}", setting(*row), fixed_text(row->cost_ms, 2),
                                    fixed_text(row->error, 4)));
    }
    std::string text =
        names.size() == 1
            ? fmt::format("No setting is faster or closer than {}.", names.front())
            : fmt::format("No setting beats these in both time and error: {}.", fmt::join(names, "; "));
    text += untold_text(rows);
    if (budget_ms) {
        const SweepRow* best = nullptr;
        for (const SweepRow* row : front) {
            if (*row->cost_ms <= *budget_ms) best = row;
        }
        text += best == nullptr
                    ? fmt::format(" Nothing fits into {} ms.", short_text(*budget_ms))
                    : fmt::format(" Within {} ms the closest is {}.", short_text(*budget_ms), setting(*best));
    }
    return text;
}

/// Which setting shows the most of what one depth layer cannot know; empty where that is not known of any.
std::string finder_text(const Rows& rows) {
    const auto most = std::ranges::max_element(rows, {}, &SweepRow::beyond_layer);
    if (most == rows.end() || !(*most)->beyond_layer) return {};
    return fmt::format("Of the occlusion that one depth layer cannot know, {} shows the most: {} %.",
                       setting(**most), percent_text((*most)->beyond_layer, 1));
}

std::optional<double> median_fixed_pass(const Rows& rows) {
    std::vector<double> all;
    for (const SweepRow* row : rows) {
        if (row->cell->fixed_pass.median_ms) all.push_back(*row->cell->fixed_pass.median_ms);
    }
    if (all.empty()) return std::nullopt;
    return median(std::move(all));
}

json rows_model(const Rows& rows, const SweepRecord& sweep) {
    std::vector<std::optional<double>> costs;
    for (const SweepRow* row : rows) costs.push_back(row->cost_ms);
    const int decimals = column_decimals(costs);
    json model = {{"answer", answer(rows, sweep.budget_ms)},
                  {"budget", sweep.budget_ms.has_value()},
                  {"data", script_json(sweep_chart(rows, sweep.budget_ms))},
                  {"rows", json::array()},
                  {"frames", frame_rows(rows)}};
    for (const SweepRow* row : rows) model["rows"].push_back(row_model(*row, decimals));
    model["has_frames"] = !model["frames"].empty();
    const bool has_layers =
        std::ranges::any_of(rows, [](const SweepRow* row) { return row->cell->layer_bytes.has_value(); });
    const bool has_findings = has_layers && std::ranges::any_of(rows, has_finding);
    model["finder"] = has_findings ? finder_text(rows) : "";
    model["has_layers"] = has_layers;
    model["has_findings"] = has_findings;
    model["columns"] =
        std::to_string(8 + (has_layers ? 1 : 0) + (has_findings ? 3 : 0));  // beside method and setting
    return model;
}

/// The lighting of frames, and the spread of the G-buffer's time, which all settings share.
std::string light_text(const ViewRecord& view) {
    std::vector<std::string> parameters;
    for (const auto& [id, value] : view.lighting_parameters)
        parameters.push_back(fmt::format("{} {}", id, value.text()));
    return fmt::format("lit by {} ({}); G-buffer {} ms; ± is half the interquartile range", view.lighting,
                       fmt::join(parameters, ", "),
                       with_spread(view.gbuffer, column_decimals({view.gbuffer.median_ms})));
}

json view_model(const ViewRecord& view, const Rows& rows, const SweepRecord& sweep) {
    json model = rows_model(rows, sweep);
    model["printed"] = printed_times(sweep, rows);
    model["has_printed"] = !model["printed"]["rows"].empty();
    model["key"] = view.key;
    model["about"] =
        fmt::format("{}×{}, ranked at R {} m", view.width, view.height, short_text(view.radius_m));
    model["unit"] =
        fmt::format("the fixed pass of 16 fetches takes {} ms", fixed_text(median_fixed_pass(rows), 2));
    model["light"] = light_text(view);
    return model;
}

json over_views_model(const SweepRowsOverViews& all, const SweepRecord& sweep) {
    Rows rows;
    for (const SweepRow& row : all.rows) rows.push_back(&row);
    std::vector<std::string> keys;
    for (const ViewRecord* view : all.views) keys.push_back(view->key);
    const ViewRecord& first = *all.views.front();
    json model = rows_model(rows, sweep);
    model["has_printed"] = false;
    model["key"] = fmt::format("Over {} views", all.views.size());
    model["about"] =
        fmt::format("{}, {}×{}, ranked at R {} m; only settings that were measured in all of them",
                    fmt::join(keys, ", "), first.width, first.height, short_text(first.radius_m));
    model["light"] = "times are means over views";
    model["unit"] = "an error is the root of the mean square over views, a cost the mean";
    return model;
}

/// The results that a definition's source states of its own measurements.
json stated_models(const json& definition) {
    json list = json::array();
    for (const json& stated : definition.value("stated", json::array())) {
        const json& value = stated.at("value");
        std::string text = value.is_null()     ? "not in the text"
                           : value.is_string() ? value.get<std::string>()
                                               : short_text(value.get<double>());
        const std::string unit = stated.value("unit", "");
        if (!unit.empty() && !value.is_null()) text += " " + unit;
        list.push_back({{"what", stated.at("what")}, {"value", text}, {"where", stated.at("where")}});
    }
    return list;
}

/// What becomes of the claims that a definition names: a sentence on all, and one on each.
void add_conclusions(json& model, const json& ids, const std::vector<ClaimRecord>& records) {
    std::size_t hold = 0, fail = 0;
    model["claims"] = json::array();
    for (const json& id : ids) {
        const ClaimRecord* claim = find_row(records, id.get<std::string>());
        if (claim == nullptr) continue;
        hold += claim->verdict == ClaimRecord::kHolds ? 1 : 0;
        fail += claim->verdict == ClaimRecord::kFails ? 1 : 0;
        model["claims"].push_back({{"id", claim->id},
                                   {"claim", claim->claim},
                                   {"verdict", claim->verdict},
                                   {"style", verdict_style(claim->verdict)},
                                   {"numbers", deciding_text(*claim)}});
    }
    model["has_claims"] = !model["claims"].empty();
    model["conclusion"] = verdict_counts_text(model["claims"].size(), hold, fail);
}

json source_model(const json& definition, const Results& results) {
    if (!definition.is_object()) return false;
    json model = {
        {"text", source_reference(StrictObject(definition.at("source"), "results.json: sweeps: source"))},
        {"hardware", definition.at("hardware").get<std::string>()},
        {"stated", stated_models(definition)},
        {"notes", definition.value("notes", json::array())}};
    add_conclusions(model, definition.value("claims", json::array()), results.claims);
    model["has_stated"] = !model["stated"].empty();
    return model;
}

/// Says why there is no number over all of a sweep's views; empty where there is one.
std::string apart_text(const std::vector<std::pair<const ViewRecord*, Rows>>& views) {
    std::vector<const ViewRecord*> all;
    for (const auto& [view, rows] : views) all.push_back(view);
    const std::size_t groups = comparable_views(all).size();
    if (groups < 2) return {};
    return fmt::format(
        "The {} views have {} different radii or sizes. Numbers over views cover those with the same radius "
        "and "
        "size; --radius ranks all of them at one radius.",
        all.size(), groups);
}

json sweep_model(const Results& results, const SweepRecord& sweep) {
    const std::vector<SweepRow> rows = sweep_rows(results, sweep);
    std::vector<std::pair<const ViewRecord*, Rows>> views;
    for (const SweepRow& row : rows) {
        auto found =
            std::find_if(views.begin(), views.end(), [&](const auto& v) { return v.first == row.view; });
        if (found == views.end()) found = views.insert(views.end(), {row.view, {}});
        found->second.push_back(&row);
    }
    std::vector<std::string> notes = sweep.notes;
    if (const std::string apart = apart_text(views); !apart.empty()) notes.push_back(apart);
    json model = {{"title", sweep.title},
                  {"has_notes", !notes.empty()},
                  {"notes", notes},
                  {"source", source_model(sweep.definition, results)},
                  {"count", std::to_string(rows.size())},
                  {"confidence", percent_text(sweep.timing_confidence, 0)},
                  {"axes", fmt::format("{}", fmt::join(sweep.axes, ", "))},
                  {"views", json::array()}};
    for (const SweepRowsOverViews& all : rows_over_views(rows))
        model["views"].push_back(over_views_model(all, sweep));
    for (const auto& [view, of_view] : views) model["views"].push_back(view_model(*view, of_view, sweep));
    return model;
}

}  // namespace

json section::sweeps(const PageSource& source) {
    json model = {{"sweeps", json::array()}};
    std::size_t settings = 0;
    for (const SweepRecord& sweep : source.results.sweeps) {
        settings += sweep.points.size();
        model["sweeps"].push_back(sweep_model(source.results, sweep));
    }
    const json& all = model["sweeps"];
    const bool one_answer = all.size() == 1 && all[0].at("views").size() == 1;
    model["in_short"] =
        one_answer
            ? all[0].at("views")[0].at("answer").get<std::string>()
            : fmt::format("{} of {} {} timed and scored.", counted(settings, "setting", "settings"),
                          counted(model["sweeps"].size(), "sweep", "sweeps"), settings == 1 ? "was" : "were");
    return model;
}

}  // namespace aoscore
