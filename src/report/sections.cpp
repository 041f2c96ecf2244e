#include "core/error.h"
#include "report/number_text.h"
#include "report/section.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

const std::vector<Section>& sections() {
    static const std::vector<Section> table = {
        {"verdict", "Verdict", section::verdict},
        {"ranking", "Ranking", section::ranking},
        {"pictures", "Pictures", section::pictures},
        {"cost", "Run time against error", section::cost},
        {"failures", "Where it fails", section::failures},
        {"distributions", "Errors in detail", section::distributions},
        {"live", "Live parameters", section::live},
        {"published", "Published tables beside ours", section::published},
        {"measurement", "How it was measured", section::measurement},
    };
    return table;
}

const CellRecord* find_cell(const Results& results, const std::string& id) {
    const auto found = std::find_if(results.cells.begin(), results.cells.end(),
                                    [&](const CellRecord& cell) { return cell.id == id; });
    return found == results.cells.end() ? nullptr : &*found;
}

const ViewRecord& find_view(const Results& results, const std::string& key) {
    const auto found = std::find_if(results.views.begin(), results.views.end(),
                                    [&](const ViewRecord& view) { return view.key == key; });
    if (found == results.views.end()) throw file_error("names a view that it lacks, " + key, "results.json");
    return *found;
}

const TruthRecord* find_truth(const ViewRecord& view, const std::string& id) {
    const auto found = std::find_if(view.truths.begin(), view.truths.end(),
                                    [&](const TruthRecord& truth) { return truth.id == id; });
    return found == view.truths.end() ? nullptr : &*found;
}

std::optional<double> cost_ms(const CellRecord& cell) {
    if (!cell.ao.median_ms) return std::nullopt;
    return *cell.ao.median_ms + cell.blur.median_ms.value_or(0);
}

std::string truth_text(const TruthRecord& truth) {
    std::string text = truth.falloff;
    if (truth.u_m) text += fmt::format(", u {} m", short_text(*truth.u_m));
    return text + (truth.radius_m ? fmt::format(", R {} m", short_text(*truth.radius_m)) : ", R infinite");
}

}  // namespace aoscore
