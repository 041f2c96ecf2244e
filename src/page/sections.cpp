#include "core/error.h"
#include "core/known_names.h"
#include "page/document/number_text.h"
#include "page/section.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

namespace {

bool has_views(const Results& results) {
    return !results.views.empty();
}

bool has_costs(const Results& results) {
    return std::ranges::any_of(results.cells,
                               [](const CellRecord& cell) { return cost_ms(cell).has_value(); });
}

bool has_analyses(const Results& results) {
    return std::ranges::any_of(results.cells,
                               [](const CellRecord& cell) { return cell.analysis.has_value(); });
}

bool has_tables(const Results& results) {
    return !results.tables.empty();
}

bool has_signals(const Results& results) {
    return std::ranges::any_of(results.views, [](const ViewRecord& view) { return !view.signals.empty(); });
}

bool has_light(const Results& results) {
    return std::ranges::any_of(results.views, [](const ViewRecord& view) { return view.light.has_value(); });
}

bool has_claims(const Results& results) {
    return !results.claims.empty();
}

bool has_advice(const Results& results) {
    return !results.advice.empty();
}

bool has_sweeps(const Results& results) {
    return !results.sweeps.empty();
}

}  // namespace

const std::vector<Section>& sections() {
    using enum Section::Of;
    static const std::vector<Section> table = {
        {"verdict", "Verdict", section::verdict, ranked, has_views, false},
        {"ranking", "Ranking", section::ranking, ranked, has_views},
        {"pictures", "Pictures", section::pictures, pictured, has_views, false},
        {"sweeps", "Sweeps", section::sweeps, all, has_sweeps},
        {"cost", "Run time against error", section::cost, ranked, has_costs},
        {"advice", "The next step", section::advice, ranked, has_advice},
        {"failures", "Where it fails", section::failures, ranked, has_analyses},
        {"distributions", "Errors in detail", section::distributions, ranked, has_analyses},
        {"signals", "Bent normals and cones", section::signals, pictured, has_signals},
        {"light", "Light of an environment", section::light, pictured, has_light},
        {"live", "Live parameters", section::live, pictured, has_views},
        {"published", "Published tables beside ours", section::published, all, has_tables},
        {"claims", "Published claims", section::claims, all, has_claims},
        {"measurement", "How it was measured", section::measurement, all},
    };
    return table;
}

Results pictured(const Results& results) {
    Results part = results;
    std::erase_if(part.views, [](const ViewRecord& view) { return view.truth_file.empty(); });
    std::erase_if(part.cells, [&](const CellRecord& cell) {
        const bool seen = std::any_of(part.views.begin(), part.views.end(),
                                      [&](const ViewRecord& view) { return view.key == cell.view_key; });
        return !seen || (cell.image_file.empty() && cell.error.empty());
    });
    return part;
}

const CellRecord* find_cell(const Results& results, const std::string& id) {
    return find_row(results.cells, id);
}

const ViewRecord& find_view(const Results& results, const std::string& key) {
    const ViewRecord* view = find_row(results.views, key, &ViewRecord::key);
    if (view == nullptr) throw file_error("names a view that it lacks, " + key, "results.json");
    return *view;
}

const TruthRecord* find_truth(const ViewRecord& view, const std::string& id) {
    return find_row(view.truths, id);
}

std::optional<double> cost_ms(const CellRecord& cell) {
    if (!cell.ao.median_ms) return std::nullopt;
    return *cell.ao.median_ms + cell.filter_pass.median_ms.value_or(0);
}

std::string truth_text(const TruthRecord& truth) {
    std::string text = truth.falloff;
    if (truth.u_m) text += fmt::format(", u {} m", short_text(*truth.u_m));
    return text + (truth.radius_m ? fmt::format(", R {} m", short_text(*truth.radius_m)) : ", R infinite");
}

}  // namespace aoscore
