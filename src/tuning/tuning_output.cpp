#include "core/files.h"
#include "core/machine.h"
#include "core/output.h"
#include "metrics/evaluate.h"
#include "results/tuning_record.h"
#include "tuning/preset_files.h"
#include "tuning/tuning_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

std::string_view verdict_id(HeldOut::Verdict verdict) {
    switch (verdict) {
        case HeldOut::Verdict::closer:
            return "closer";
        case HeldOut::Verdict::farther:
            return "farther";
        case HeldOut::Verdict::tie:
            break;
    }
    return "tie";
}

/// What settings cost, in words: "36.0 fetches", "36.0 fetches, 7.91 ms".
std::string cost_text(double fetches, const std::optional<double>& ms) {
    return fmt::format("{:.1f} fetches{}", fetches, ms ? fmt::format(", {:.2f} ms", *ms) : "");
}

BudgetRecord budget_record(const MethodTuning& tuning, const TunedMethod& t) {
    BudgetRecord record;
    record.most_fetches = t.budget.fetches;
    record.most_ms = t.budget.ms;
    record.preset_id = tuned_preset_id(tuning.cell.preset, t.budget);
    record.settings = values_of(tuning.axes, t.settings);
    record.published = {t.published_loss, t.published_fetches, t.published_ms, t.published_by_view};
    record.tuned = {t.fitted_loss, t.fetches, t.ms, t.fitted_by_view};
    for (const HeldOut& h : t.held_out) {
        record.held_out.push_back(
            {h.groups, h.loss, h.gain, {h.low, h.high}, std::string(verdict_id(h.verdict()))});
    }
    for (const ParameterWorth& w : t.worth)
        record.worth.push_back({w.parameter, w.published, w.tuned, w.alone, w.without});
    return record;
}

void print_budget(const MethodTuning& tuning, const TunedMethod& t) {
    const std::string limit = budget_text(t.budget);
    print_result("\n{}{}: {:.4f} as {} ({}), {:.4f} tuned ({})\n", tuning.label,
                 limit.empty() ? "" : ", " + limit, t.published_loss, tuning.cell.preset,
                 cost_text(t.published_fetches, t.published_ms), t.fitted_loss, cost_text(t.fetches, t.ms));
    for (const HeldOut& h : t.held_out) {
        print_result(
            "  {:.4f} on a {} that it was not tuned on: {:+.4f} against {} ({:+.4f} to {:+.4f}): {}\n",
            h.loss, h.groups, h.gain, tuning.cell.preset, h.low, h.high,
            h.verdict() == HeldOut::Verdict::tie ? "a tie" : verdict_id(h.verdict()));
    }
    print_result("  {:<22} {:>12} {:>12} {:>14} {:>16}\n", "parameter", "published", "tuned", "tuned alone",
                 "all tuned but it");
    for (const ParameterWorth& w : t.worth) {
        print_result("  {:<22} {:>12.5g} {:>12.5g} {:>14.4f} {:>16.4f}\n", w.parameter, w.published, w.tuned,
                     w.alone, w.without);
    }
    for (std::size_t i = 0; i < t.settings.size(); ++i) {
        const SearchAxis& axis = tuning.axes[i];
        if (axis.ends_search(t.settings[i]))
            print_result(
                "  {} ends at a limit of the search, {:.5g} to {:.5g}: beyond it may be better ones\n",
                axis.parameter, axis.low, axis.high);
    }
}

}  // namespace

TuningRecord tuning_record(const TuningResults& results, const TuningPlan& plan) {
    TuningRecord record;
    record.program_version = version();
    record.created_utc = utc_now();
    record.command = plan.command;
    record.definition = plan.definition;
    record.metric = plan.metric;
    record.size = {plan.width, plan.height};
    record.rays_a_pixel = plan.samples;
    for (std::size_t v = 0; v < results.views.size(); ++v)
        record.views.push_back({results.views[v], results.radii_m[v]});
    for (const MethodTuning& tuning : results.methods) {
        MethodTuningRecord& method = record.methods.emplace_back();
        method.method = tuning.cell.method;
        method.label = tuning.label;
        method.preset = tuning.cell.preset;
        method.drawn = tuning.drawn;
        method.reused = tuning.reused;
        for (const TunedMethod& t : tuning.budgets) method.budgets.push_back(budget_record(tuning, t));
    }
    return record;
}

void write_tuning(const TuningResults& results, const TuningPlan& plan, const std::filesystem::path& folder) {
    for (const auto& [method, presets] : preset_files(results, plan))
        write_atomically(folder / preset_file_name(method), presets.dump(2) + "\n");
    write_tuning_record(tuning_record(results, plan), folder);
}

void print_tuning(const TuningResults& results, const TuningPlan& plan) {
    print_result("{} over {} views, truth of {} rays a pixel\n", metric(plan.metric).label,
                 results.views.size(), plan.samples);
    for (const MethodTuning& tuning : results.methods) {
        for (const TunedMethod& t : tuning.budgets) print_budget(tuning, t);
    }
    if (std::ranges::any_of(plan.budgets, [](const Budget& budget) { return budget.ms.has_value(); }))
        print_result("\nMilliseconds are those of this machine at {}x{} on {}.\n", plan.width, plan.height,
                     results.views.front());
}

}  // namespace aoscore
