#include "experiment/work_plan.h"

#include "core/counted.h"
#include "core/hash.h"
#include "core/machine.h"
#include "core/threads.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

double megapixels(const ViewRun& run) {
    return run.work.width * 1e-6 * run.work.height;
}

/// Seconds for a million pixels: of the truth for each ray, and of all else for each cell.
struct Pace {
    double truth = 0, cell = 0;
};

std::string pace_key() {
    return Digest().text("pace").text(cpu_name()).value(thread_count()).hex();
}

std::optional<Pace> find_pace(const ArtifactStore& store) {
    const auto found = store.find(pace_key());
    if (!found || !found->is_object()) return std::nullopt;
    const Pace pace{found->value("truth", 0.0), found->value("cell", 0.0)};
    return pace.truth > 0 && pace.cell > 0 ? std::optional(pace) : std::nullopt;
}

/// Whether a cell's numbers are all in the store.
bool is_known(const ViewJobs& jobs, const CellKeys& keys, const ArtifactStore& store) {
    const auto known = [&](const std::optional<Key>& key) { return !key || store.has(key->hex); };
    const bool pictured = std::ranges::find(jobs.graph.wanted(), keys.image) != jobs.graph.wanted().end();
    return known(keys.score) && known(keys.own_score) && known(keys.fetches) && known(keys.times) &&
           (!pictured || known(keys.image));
}

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(seconds, 1.0));
    return fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace

std::string WorkPlan::text() const {
    const std::size_t to_do = cells - cells_known;
    std::string text =
        fmt::format("plan: {} on {}; ", counted(cells, "cell", "cells"), counted(views, "view", "views"));
    if (to_do == 0 && views_known == views) return text + "all measured before";
    text += fmt::format("{} measured before, {} to do", cells_known, to_do);
    if (views_known < views) text += fmt::format(", {} to trace", views - views_known);
    return text + (seconds ? ", about " + duration_text(*seconds) : std::string(", time not known yet"));
}

std::string WorkPlan::rest_text() const {
    return fmt::format("{}, about {}", counted(views, "more view", "more views"),
                       duration_text(seconds.value_or(0)));
}

WorkPlan plan_work(std::span<const ViewRun> runs, const ArtifactStore& store) {
    WorkPlan plan;
    const std::optional<Pace> pace = find_pace(store);
    double seconds = 0;
    for (const ViewRun& run : runs) {
        const auto known = static_cast<std::size_t>(std::ranges::count_if(
            run.jobs.cells, [&](const CellKeys& keys) { return is_known(run.jobs, keys, store); }));
        const bool view_known = store.has(run.jobs.view.hex);
        ++plan.views;
        plan.views_known += view_known;
        plan.cells += run.cells.size();
        plan.cells_known += known;
        if (!pace || is_known(run, store)) continue;
        seconds += megapixels(run) * pace->cell * static_cast<double>(run.cells.size() - known);
        if (!view_known) seconds += megapixels(run) * pace->truth * run.plan.samples;
    }
    if (pace) plan.seconds = seconds;
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
    const double truth_s = outcome.view.truth_seconds;
    const Pace now{
        truth_s / (megapixels(run) * run.plan.samples),
        std::max(seconds - truth_s, 0.0) / (megapixels(run) * static_cast<double>(outcome.measured))};
    const Pace before = find_pace(store).value_or(now);
    store.put(pace_key(),
              {{"truth", (before.truth + now.truth) / 2}, {"cell", (before.cell + now.cell) / 2}});
}

}  // namespace aoscore
