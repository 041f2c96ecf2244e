#include "page/sections/tuned_rows.h"

#include "core/counted.h"
#include "metrics/evaluate.h"
#include "page/document/number_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>

namespace aoscore {
namespace {

using nlohmann::json;

std::string signed_number(double value, int decimals) {
    return (value > 0 ? "+" : "") + fixed_text(value, decimals);
}

std::string with_interval(double value, double low, double high, int decimals) {
    return fmt::format("{} ({} to {})", signed_number(value, decimals), signed_number(low, decimals),
                       signed_number(high, decimals));
}

/// "0.0312 less error with SSAO (27 %)".
std::string outcome_text(const std::string& name, const StepRecord& step, double before, int decimals) {
    const double change = *step.error - before;
    if (step.verdict == StepRecord::kTie) return "no sure change with " + name;
    return fmt::format("{} {} error with {} ({} %)", fixed_text(std::abs(change), decimals),
                       change < 0 ? "less" : "more", name, percent_text(std::abs(change) / before, 0));
}

std::string answer(const std::vector<std::string>& outcomes, std::size_t closer) {
    if (outcomes.empty()) return "No row has a tuned preset that could be measured.";
    const std::string count = closer == 0 ? "none" : std::to_string(closer);
    return fmt::format("Of {}, {} {} closer to the truth with tuned settings at as many taps: {}.",
                       counted(outcomes.size(), "row", "rows"), count, closer > 1 ? "are" : "is",
                       fmt::join(outcomes, ", "));
}

/// The change on groups of views that the preset was not tuned on.
std::string held_out_text(const json& tuning, int decimals) {
    const auto found = tuning.find("held_out");
    if (found == tuning.end()) return kNoNumber;
    const json& interval = found->at("less_published_95");
    return with_interval(found->at("less_published").get<double>(), interval.at(0).get<double>(),
                         interval.at(1).get<double>(), decimals);
}

json measured_row(const TunedRowRecord& row, const StepRecord& step, int decimals) {
    json model = {{"what", step.what},
                  {"measured", true},
                  {"verdict", step.verdict},
                  {"before", fixed_text(row.step.error, decimals)},
                  {"after", fixed_text(step.error, decimals)},
                  {"fetches", step.fetches ? signed_number(*step.fetches, 1) : std::string(kNoNumber)},
                  {"left_out", held_out_text(row.tuning, decimals)}};
    model["change"] = step.change ? with_interval(*step.error - row.step.error, step.change->low,
                                                  step.change->high, decimals)
                                  : std::string(kNoNumber);
    return model;
}

/// Why nothing was measured.
std::string reason_of(const AdviceRecord& advice) {
    if (!advice.skipped.empty()) return advice.skipped.front().reason;
    if (!advice.steps.empty()) return advice.steps.front().reason;
    return "the row failed";
}

}  // namespace

json tuned_rows_model(const TableRecord& table, const std::vector<const CellRecord*>& cells) {
    if (table.tuned.size() != cells.size()) return false;
    json rows = json::array();
    std::vector<std::string> outcomes;
    std::size_t closer = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const TunedRowRecord& row = table.tuned[i];
        const std::string name = shown_name(*cells[i]);
        json model = {{"measured", false}, {"reason", reason_of(row.step)}};
        if (!row.step.steps.empty() && row.step.steps.front().error) {
            const StepRecord& step = row.step.steps.front();
            const int decimals = metric(row.step.metric).decimals;
            model = measured_row(row, step, decimals);
            outcomes.push_back(outcome_text(name, step, row.step.error, decimals));
            closer += step.verdict == StepRecord::kCloser;
        }
        model["method"] = name;
        rows.push_back(std::move(model));
    }
    return {{"answer", answer(outcomes, closer)}, {"rows", std::move(rows)}};
}

}  // namespace aoscore
