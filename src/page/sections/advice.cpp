#include "core/counted.h"
#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "results/advice_text.h"
#include "results/step_kinds.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

std::string sort_text(std::optional<double> value) {
    return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "";
}

/// A difference with its sign.
std::string signed_text(std::optional<double> value, int decimals) {
    return value && *value > 0 ? "+" + fixed_text(value, decimals) : fixed_text(value, decimals);
}

std::string interval_text(const std::optional<Interval>& interval, int decimals) {
    if (!interval) return kNoNumber;
    return fmt::format("{} to {}", signed_text(interval->low, decimals),
                       signed_text(interval->high, decimals));
}

json cell_model(std::optional<double> value, std::string text) {
    return {{"text", std::move(text)}, {"sort", sort_text(value)}};
}

json step_model(const AdviceRecord& advice, const StepRecord& step) {
    const int decimals = metric(advice.metric).decimals;
    const std::optional<double> per_ms = bought_per_ms(step, advice.error);
    const std::optional<double> per_fetch = bought_per_fetch(step, advice.error);
    const std::optional<double> change =
        step.error ? std::optional(*step.error - advice.error) : std::nullopt;
    const std::optional<double> passes = ratio(step.ms, advice.fixed_pass_ms);
    return {
        {"step", step_name(step)},
        {"verdict", step.verdict},
        {"note", step.reason},
        {"numbers",
         {cell_model(step.error, fixed_text(step.error, decimals)),
          cell_model(change, interval_text(step.change, decimals)),
          cell_model(step.ms, signed_text(step.ms, 2)), cell_model(passes, signed_text(passes, 2)),
          cell_model(per_ms, fixed_text(per_ms, 5)), cell_model(step.fetches, signed_text(step.fetches, 1)),
          cell_model(per_fetch, fixed_text(per_fetch, 5))}}};
}

json cell_advice(const AdviceRecord& advice, const CellRecord& cell) {
    json model = {{"name", fmt::format("{}, {}", shown_name(cell), cell.preset)},
                  {"error", fixed_text(advice.error, metric(advice.metric).decimals)},
                  {"ms", fixed_text(advice.ms, 2)},
                  {"fetches", fixed_text(advice.fetches, 1)},
                  {"steps", json::array()},
                  {"skipped", json::array()}};
    for (const StepRecord& step : advice.steps) model["steps"].push_back(step_model(advice, step));
    for (const SkippedStep& skipped : advice.skipped)
        model["skipped"].push_back({{"step", step_label(skipped.id)}, {"reason", skipped.reason}});
    model["has_skipped"] = !advice.skipped.empty();
    return model;
}

}  // namespace

json section::advice(const PageSource& source) {
    const Results& results = source.results;
    json model = {{"views", json::array()}, {"kinds", json::array()}};
    for (const StepKind& kind : step_kinds())
        model["kinds"].push_back(
            {{"label", std::string(kind.label)}, {"meaning", std::string(kind.meaning)}});
    std::size_t steps = 0;
    for (const ViewRecord& view : results.views) {
        json cells = json::array();
        for (const AdviceRecord& advice : results.advice) {
            const CellRecord* cell = find_cell(results, advice.cell_id);
            if (cell == nullptr || cell->view_key != view.key || advice.steps.empty()) continue;
            steps += advice.steps.size();
            cells.push_back(cell_advice(advice, *cell));
        }
        if (!cells.empty()) model["views"].push_back({{"key", view.key}, {"cells", std::move(cells)}});
    }
    const std::string leading = leading_advice(results);
    model["in_short"] =
        leading.empty() ? counted(steps, "step was measured.", "steps were measured.") : leading;
    return model;
}

}  // namespace aoscore
