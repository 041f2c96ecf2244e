#include "verdict/baseline.h"

#include "core/known_names.h"
#include "core/sampling.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace aoscore {
namespace {

/// Rays a pixel from which on a truth that is not in halves leaves debiased errors as one in halves does: on
/// cathedral/nave GTAO's debiased RMSE is .1338 .1407 .1434 .1442 .1443 .1444 at 4, 8, 16, 32, 64, 256 rays.
constexpr int kFewRays = 64;

bool debias_alike(const ViewRecord& view) {
    return view.halves || view.samples >= kFewRays;
}

/// Says why scores of two views cannot be compared; empty where they can.
std::string difference(const ViewRecord& now, const ViewRecord& before) {
    if (now.scene_digest != before.scene_digest) return "the scene has changed";
    if (now.width != before.width || now.height != before.height) return "the images differ in size";
    if (now.position_m != before.position_m || now.target_m != before.target_m || now.up != before.up ||
        now.projection != before.projection || now.fovy_deg != before.fovy_deg ||
        now.half_height_m != before.half_height_m) {
        return "the camera has changed";
    }
    if (now.radius_m != before.radius_m) return "the radius has changed";
    if (now.samples != before.samples && !(debias_alike(now) && debias_alike(before))) {
        return fmt::format(
            "the truth had {} rays a pixel and now has {}; a truth that is not in halves debiases errors "
            "alike "
            "from {} on",
            before.samples, now.samples, kFewRays);
    }
    return {};
}

/// Says why two cells cannot be compared; empty where they can.
std::string obstacle(const Results& now, const CellRecord& cell, const Results& before,
                     const CellRecord* old) {
    if (old == nullptr) return "not in the earlier run";
    if (!old->analysis) return "failed in the earlier run: " + old->error;
    const ViewRecord* view = find_row(now.views, cell.view_key, &ViewRecord::key);
    const ViewRecord* old_view = find_row(before.views, old->view_key, &ViewRecord::key);
    if (view == nullptr || old_view == nullptr) return "a view is not there";
    if (const std::string text = difference(*view, *old_view); !text.empty()) return text;
    if (cell.analysis && cell.analysis->blocks.counts != old->analysis->blocks.counts)
        return "other pixels are valid";
    return {};
}

/// The cell of the earlier run to compare with: the one of the same id, else the only one of its method,
/// preset and filter on the view, so that changed parameters can be compared.
const CellRecord* earlier_cell(const CellRecord& cell, const Results& before) {
    if (const CellRecord* same = find_row(before.cells, cell.id)) return same;
    const CellRecord* only = nullptr;
    for (const CellRecord& old : before.cells) {
        if (old.view_key != cell.view_key || old.method != cell.method || old.preset != cell.preset ||
            old.filter != cell.filter)
            continue;
        if (only != nullptr) return nullptr;
        only = &old;
    }
    return only;
}

/// A change, with the metric's draws now and before where it can be resampled.
struct Compared {
    ChangeRecord change;
    std::vector<Resampled> now_and_before;
};

std::string metric_of(const CellRecord& cell, const CellRecord* old) {
    std::vector<const CellRecord*> cells{&cell};
    if (old != nullptr) cells.push_back(old);
    return ranking_metric(cells);
}

Compared compared(const Results& now, const CellRecord& cell, const Results& before) {
    const CellRecord* old = earlier_cell(cell, before);
    Compared result;
    ChangeRecord& change = result.change;
    change.cell_id = cell.id;
    change.metric = metric_of(cell, old);
    change.now = value_of(cell.ranked, change.metric);
    if (old != nullptr) change.before = value_of(old->ranked, change.metric);
    change.reason = obstacle(now, cell, before, old);
    if (!change.reason.empty()) {
        change.verdict = "not comparable";
    } else if (!cell.analysis) {
        change.verdict = "worse";
        change.reason = "failed: " + cell.error;
    } else if (change.now && change.before) {
        // Views are resampled independently: a chance that they shared would look like certainty.
        const auto view = std::ranges::find(now.views, cell.view_key, &ViewRecord::key);
        const std::uint64_t seed = mix_bits(now.seed + static_cast<std::uint64_t>(view - now.views.begin()));
        for (const CellRecord* one : {&cell, old}) {
            const std::array<const BlockErrors*, 1> blocks{&one->analysis->blocks};
            result.now_and_before.push_back(
                {*value_of(one->ranked, change.metric), resampled(change.metric, blocks, seed)});
        }
    }
    return result;
}

/// Gives every change that can be resampled its interval, simultaneous for all of them, and its verdict.
void judge(std::vector<Compared>& comparisons) {
    std::vector<Resampled> measures;
    std::vector<MeasurePair> pairs;
    std::vector<ChangeRecord*> changes;
    for (Compared& one : comparisons) {
        if (!one.change.verdict.empty()) continue;
        changes.push_back(&one.change);
        if (one.now_and_before.empty()) one.now_and_before.resize(2);
        pairs.emplace_back(measures.size(), measures.size() + 1);
        std::ranges::move(one.now_and_before, std::back_inserter(measures));
    }
    const auto intervals = simultaneous_intervals(measures, pairs);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ChangeRecord& change = *changes[i];
        change.change = intervals[i];
        if (!change.change) {
            change.verdict = "not comparable";
            change.reason = "the difference has no interval: the picture is too small, or has no such value";
        } else {
            change.verdict = change.change->holds_zero() ? "same"
                             : change.change->low > 0    ? "worse"
                                                         : "better";
        }
    }
}

}  // namespace

BaselineRecord against_baseline(const Results& now, const Results& before) {
    std::vector<Compared> comparisons;
    for (const CellRecord& cell : now.cells) comparisons.push_back(compared(now, cell, before));
    judge(comparisons);
    BaselineRecord record{before.program_version, before.created_utc, before.command, {}};
    for (Compared& one : comparisons) record.changes.push_back(std::move(one.change));
    return record;
}

std::string other_truths(const Results& now, const Results& before) {
    const bool other = std::ranges::any_of(now.views, [&](const ViewRecord& view) {
        const ViewRecord* old = find_row(before.views, view.key, &ViewRecord::key);
        return old != nullptr && old->integrator != view.integrator;
    });
    return other ? "The baseline's truths were made by another version of the ray tracer: what changed may "
                   "be the truth or its stated noise, and not the method."
                 : "";
}

}  // namespace aoscore
