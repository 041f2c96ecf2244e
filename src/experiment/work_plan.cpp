#include "experiment/work_plan.h"

#include "core/counted.h"
#include "core/hash.h"
#include "core/machine.h"
#include "core/pace.h"
#include "core/rough_text.h"
#include "core/threads.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

double megapixels(const ViewRun& run) {
    return run.work.width * 1e-6 * run.work.height;
}

/// Of truths by millions of pixels times rays a pixel, and of cells by millions of pixels.
struct Paces {
    // Of two cores at 3 GHz.
    Pace truth{.fixed_s = 0.1, .unit_s = 0.1}, cell{.fixed_s = 0.3, .unit_s = 2};
};

std::string pace_key() {
    return Digest().text("paces").text(cpu_name()).value(thread_count()).hex();
}

/// What is kept of a pace; the guess stays ours.
nlohmann::json kept(const Pace& pace) {
    return {pace.count, pace.sizes, pace.squares, pace.seconds, pace.products};
}

void take(const nlohmann::json& kept, Pace& pace) {
    if (!kept.is_array() || kept.size() != 5) return;
    std::size_t i = 0;
    for (double* sum : {&pace.count, &pace.sizes, &pace.squares, &pace.seconds, &pace.products}) {
        const nlohmann::json& number = kept[i++];
        *sum = number.is_number() ? number.get<double>() : 0;
    }
}

/// Empty where nothing was measured.
std::optional<Paces> find_paces(const ArtifactStore& store) {
    const auto found = store.find(pace_key());
    if (!found || !found->is_object()) return std::nullopt;
    Paces paces;
    take(found->value("truth", nlohmann::json()), paces.truth);
    take(found->value("cell", nlohmann::json()), paces.cell);
    return paces.cell.count > 0 ? std::optional(paces) : std::nullopt;
}

/// Whether a cell's numbers are all in the store.
bool is_known(const ViewJobs& jobs, const CellKeys& keys, const ArtifactStore& store) {
    const auto known = [&](const std::optional<Key>& key) { return !key || store.has(key->hex); };
    const bool pictured = std::ranges::find(jobs.graph.wanted(), keys.image) != jobs.graph.wanted().end();
    return known(keys.score) && known(keys.own_score) && known(keys.fetches) && known(keys.times) &&
           known(keys.light) && known(keys.lit_file) && (!pictured || known(keys.image));
}

}  // namespace

std::string WorkPlan::text() const {
    const std::size_t to_do = cells - cells_known;
    std::string text =
        fmt::format("plan: {} on {}; ", counted(cells, "cell", "cells"), counted(views, "view", "views"));
    if (to_do == 0 && views_known == views) return text + "all measured before";
    text += fmt::format("{} measured before, {} to do", cells_known, to_do);
    if (views_known < views) text += fmt::format(", {} to trace", views - views_known);
    return text + (seconds ? ", about " + rough_duration(*seconds) : std::string(", time not known yet"));
}

std::string WorkPlan::rest_text() const {
    return fmt::format("{}, about {}", counted(views, "more view", "more views"),
                       rough_duration(seconds.value_or(0)));
}

WorkPlan plan_work(std::span<const ViewRun> runs, const ArtifactStore& store) {
    WorkPlan plan;
    const std::optional<Paces> paces = find_paces(store);
    double seconds = 0;
    for (const ViewRun& run : runs) {
        const auto known = static_cast<std::size_t>(std::ranges::count_if(
            run.jobs.cells, [&](const CellKeys& keys) { return is_known(run.jobs, keys, store); }));
        const bool view_known = store.has(run.jobs.view.hex);
        ++plan.views;
        plan.views_known += view_known;
        plan.cells += run.cells.size();
        plan.cells_known += known;
        if (!paces || is_known(run, store)) continue;
        seconds += paces->cell.predicted_s(megapixels(run)) * static_cast<double>(run.cells.size() - known);
        if (!view_known) seconds += paces->truth.predicted_s(megapixels(run) * run.plan.samples);
    }
    if (paces) plan.seconds = seconds;
    return plan;
}

bool is_known(const ViewRun& run, const ArtifactStore& store) {
    return std::ranges::all_of(run.jobs.graph.wanted(), [&](const Key& key) { return store.has(key.hex); });
}

bool is_scored(const ViewRun& run, const ArtifactStore& store) {
    return std::ranges::all_of(run.jobs.cells,
                               [&](const CellKeys& keys) { return store.has(keys.score.hex); });
}

void learn_pace(const ArtifactStore& store, const ViewRun& run, const ViewOutcome& outcome, double seconds) {
    if (!store.enabled() || outcome.measured == 0 || outcome.rays == 0) return;
    // Other programs take what time they will: nothing follows from it for ours.
    const bool has_foreign = std::ranges::any_of(
        run.work.cells, [](const CellWork& cell) { return cell.contestant->timed_request() == nullptr; });
    if (has_foreign) return;
    const double truth_s = outcome.view.truth_seconds;
    Paces paces = find_paces(store).value_or(Paces());
    paces.truth.observe(megapixels(run) * run.plan.samples, truth_s);
    paces.cell.observe(megapixels(run),
                       std::max(seconds - truth_s, 0.0) / static_cast<double>(outcome.measured));
    store.put(pace_key(), {{"truth", kept(paces.truth)}, {"cell", kept(paces.cell)}});
}

}  // namespace aoscore
