#include "core/files.h"
#include "core/output.h"
#include "metrics/evaluate.h"
#include "tuning/preset_files.h"
#include "tuning/tuning_run.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

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

json or_null(const std::optional<double>& value) {
    return value ? json(*value) : json();
}

/// What settings cost, in words: "36.0 fetches", "36.0 fetches, 7.91 ms".
std::string cost_text(double fetches, const std::optional<double>& ms) {
    return fmt::format("{:.1f} fetches{}", fetches, ms ? fmt::format(", {:.2f} ms", *ms) : "");
}

json budget_json(const MethodTuning& tuning, const TunedMethod& t) {
    json held_out = json::array(), worth = json::array();
    for (const HeldOut& h : t.held_out) {
        held_out.push_back({{"left_out", h.groups},
                            {"loss", h.loss},
                            {"less_published", h.gain},
                            {"less_published_95", {h.low, h.high}},
                            {"verdict", verdict_id(h.verdict())}});
    }
    for (const ParameterWorth& w : t.worth) {
        worth.push_back({{"parameter", w.parameter},
                         {"published", w.published},
                         {"tuned", w.tuned},
                         {"loss_alone", w.alone},
                         {"loss_without", w.without}});
    }
    return {{"most_fetches", or_null(t.budget.fetches)},
            {"most_ms", or_null(t.budget.ms)},
            {"settings", values_json(tuning.axes, t.settings)},
            {"published",
             {{"loss", t.published_loss},
              {"fetches", t.published_fetches},
              {"ms", or_null(t.published_ms)},
              {"loss_by_view", t.published_by_view}}},
            {"tuned",
             {{"loss", t.fitted_loss},
              {"fetches", t.fetches},
              {"ms", or_null(t.ms)},
              {"loss_by_view", t.fitted_by_view}}},
            {"held_out", std::move(held_out)},
            {"worth", std::move(worth)}};
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
}

}  // namespace

void write_tuning(const TuningResults& results, const TuningPlan& plan, const std::filesystem::path& folder) {
    json views = json::array(), methods = json::array();
    for (std::size_t v = 0; v < results.views.size(); ++v)
        views.push_back({{"view", results.views[v]}, {"radius_m", results.radii_m[v]}});
    for (const MethodTuning& tuning : results.methods) {
        json budgets = json::array();
        for (const TunedMethod& t : tuning.budgets) budgets.push_back(budget_json(tuning, t));
        methods.push_back({{"method", tuning.cell.method},
                           {"preset", tuning.cell.preset},
                           {"drawn", tuning.drawn},
                           {"reused", tuning.reused},
                           {"budgets", std::move(budgets)}});
    }
    const json file = {
        {"schema_version", 1},       {"program_version", version()},      {"command", plan.command},
        {"metric", plan.metric},     {"size", {plan.width, plan.height}}, {"rays_a_pixel", plan.samples},
        {"views", std::move(views)}, {"methods", std::move(methods)}};
    for (const auto& [method, presets] : preset_files(results, plan))
        write_atomically(folder / (method + ".tuned.json"), presets.dump(2) + "\n");
    write_atomically(folder / "tune.json", file.dump(2) + "\n");
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
