#include "results/advice_text.h"

#include "core/known_names.h"
#include "metrics/evaluate.h"
#include "results/step_kinds.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

/// Less than this of a millisecond or a fetch is nothing to divide by.
constexpr double kLeastMore = 1e-6;

std::string number(std::optional<double> value, const char* form) {
    return value ? fmt::format(fmt::runtime(form), *value) : "-";
}

std::string interval_text(const std::optional<Interval>& interval, const char* form) {
    return interval ? fmt::format("{} to {}", number(interval->low, form), number(interval->high, form))
                    : "-";
}

/// The cell in words: "GTAO (default) on atrium/wide".
std::string subject(const Results& results, const AdviceRecord& advice) {
    const CellRecord* cell = find_row(results.cells, advice.cell_id);
    if (cell == nullptr) return advice.cell_id;
    return fmt::format("{} ({}) on {}", shown_name(*cell), cell->preset, cell->view_key);
}

/// The error that a step takes off, for each unit of what it takes more of; empty where it takes no more.
std::optional<double> bought_per(const StepRecord& step, double before, std::optional<double> more) {
    const std::optional<double> bought = step.bought(before);
    return bought && more && *more > kLeastMore ? std::optional(*bought / *more) : std::nullopt;
}

std::string step_line(const StepRecord& step, double before) {
    return fmt::format("  {:<50} {:>7} {:>19} {:>7} {:>9} {:>9} {:>8} {:>9}  {}\n", step_name(step),
                       number(step.error, "{:.4f}"), interval_text(step.change, "{:+.4f}"), step.verdict,
                       number(step.ms, "{:+.2f}"), number(bought_per_ms(step, before), "{:.5f}"),
                       number(step.fetches, "{:+.1f}"), number(bought_per_fetch(step, before), "{:.5f}"),
                       step.reason);
}

std::string price_text(const StepRecord& step) {
    if (!step.ms) return "; its cost was not timed";
    if (step.costs()) return fmt::format(", for {:.2f} ms more", *step.ms);
    if (step.ms_interval && step.ms_interval->high < 0)
        return fmt::format(", and saves {:.2f} ms", -*step.ms);
    return ", and its time does not differ significantly";
}

}  // namespace

std::optional<double> bought_per_ms(const StepRecord& step, double before) {
    return bought_per(step, before, step.ms);
}

std::optional<double> bought_per_fetch(const StepRecord& step, double before) {
    return bought_per(step, before, step.fetches);
}

std::string step_name(const StepRecord& step) {
    const std::string label = step_label(step.id);
    return step.what.empty() ? label : fmt::format("{} ({})", label, step.what);
}

std::string advice_table(const Results& results, const AdviceRecord& advice) {
    std::string text = fmt::format("{}: {} {:.4f}, {} ms, {} fetches a pixel\n", subject(results, advice),
                                   metric(advice.metric).in_text, advice.error, number(advice.ms, "{:.2f}"),
                                   number(advice.fetches, "{:.1f}"));
    if (!advice.steps.empty())
        text += fmt::format("  {:<50} {:>7} {:>19} {:>7} {:>9} {:>9} {:>8} {:>9}\n", "step", "error",
                            "change, 95 %", "", "ms", "per ms", "fetches", "per fetch");
    for (const StepRecord& step : advice.steps) text += step_line(step, advice.error);
    for (const SkippedStep& skipped : advice.skipped)
        text += fmt::format("  left out: {}: {}\n", step_label(skipped.id), skipped.reason);
    return text;
}

std::string advice_sentence(const Results& results, const AdviceRecord& advice) {
    if (advice.steps.empty()) return "";
    const StepRecord& best = advice.steps.front();
    const double bought = best.bought(advice.error).value_or(0);
    if (best.verdict != StepRecord::kCloser)
        return fmt::format("No step that was tried surely brings {} closer to the truth.",
                           subject(results, advice));
    return fmt::format("The best next step for {} is {}: it takes {:.4f} off an error of {:.4f}{}.",
                       subject(results, advice), step_name(best), bought, advice.error, price_text(best));
}

std::string leading_advice(const Results& results) {
    const AdviceRecord* leader = nullptr;
    for (const AdviceRecord& advice : results.advice) {
        const CellRecord* cell = find_row(results.cells, advice.cell_id);
        if (cell == nullptr || advice.steps.empty() || cell->view_key != results.views.front().key) continue;
        if (leader == nullptr || advice.error < leader->error) leader = &advice;
    }
    return leader == nullptr ? "" : advice_sentence(results, *leader);
}

}  // namespace aoscore
