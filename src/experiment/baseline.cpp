#include "experiment/baseline.h"

#include <algorithm>
#include <array>

namespace aoscore {
namespace {

template <class Record>
const Record* find(const std::vector<Record>& records, const std::string& id, std::string Record::*member) {
    const auto found = std::ranges::find(records, id, member);
    return found == records.end() ? nullptr : &*found;
}

std::optional<double> value_of(const CellRecord& cell, const std::string& metric) {
    const auto found = cell.ranked.find(metric);
    return found == cell.ranked.end() ? std::nullopt : found->second.value;
}

/// Why two views do not show the same; empty where they do.
std::string difference(const ViewRecord& a, const ViewRecord& b) {
    if (a.scene_digest != b.scene_digest) return "the scene has changed";
    if (a.width != b.width || a.height != b.height) return "the images differ in size";
    if (a.position_m != b.position_m || a.target_m != b.target_m || a.up != b.up ||
        a.projection != b.projection || a.fovy_deg != b.fovy_deg || a.half_height_m != b.half_height_m) {
        return "the camera has changed";
    }
    if (a.radius_m != b.radius_m) return "the radius has changed";
    return {};
}

/// Why two cells cannot be compared; empty where they can.
std::string obstacle(const Results& now, const CellRecord& cell, const Results& before,
                     const CellRecord* old) {
    if (old == nullptr) return "not in the earlier run";
    if (!old->analysis) return "failed in the earlier run: " + old->error;
    const ViewRecord* view = find(now.views, cell.view_key, &ViewRecord::key);
    const ViewRecord* old_view = find(before.views, old->view_key, &ViewRecord::key);
    if (view == nullptr || old_view == nullptr) return "a view is not there";
    if (const std::string text = difference(*view, *old_view); !text.empty()) return text;
    if (cell.analysis && cell.analysis->blocks.counts != old->analysis->blocks.counts)
        return "other pixels are valid";
    return {};
}

/// The cell of the earlier run that this one stands for: of the same id, else the only one of its method,
/// preset and filter on the view, so that a change of parameters can be held against what was before.
const CellRecord* earlier_cell(const CellRecord& cell, const Results& before) {
    if (const CellRecord* same = find(before.cells, cell.id, &CellRecord::id)) return same;
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

ChangeRecord change_of(const Results& now, const CellRecord& cell, const Results& before) {
    const CellRecord* old = earlier_cell(cell, before);
    ChangeRecord change;
    change.cell_id = cell.id;
    const bool debiased = (!cell.analysis || value_of(cell, "rmse_debiased")) &&
                          (old == nullptr || !old->analysis || value_of(*old, "rmse_debiased"));
    change.metric = debiased ? "rmse_debiased" : "rmse";
    change.now = value_of(cell, change.metric);
    if (old != nullptr) change.before = value_of(*old, change.metric);
    change.reason = obstacle(now, cell, before, old);
    if (!change.reason.empty()) {
        change.verdict = "not comparable";
        return change;
    }
    if (!cell.analysis) {
        change.verdict = "worse";
        change.reason = "failed: " + cell.error;
        return change;
    }
    const std::array<const BlockErrors*, 1> blocks{&cell.analysis->blocks},
        old_blocks{&old->analysis->blocks};
    change.change = confidence_interval(resampled(change.metric, blocks, now.seed),
                                        resampled(change.metric, old_blocks, now.seed));
    if (!change.change) {
        change.verdict = "not comparable";
        change.reason = "the difference could not be resampled";
    } else {
        change.verdict = change.change->holds_zero() ? "same" : change.change->low > 0 ? "worse" : "better";
    }
    return change;
}

}  // namespace

BaselineRecord against_baseline(const Results& now, const Results& before) {
    BaselineRecord record{before.program_version, before.created_utc, before.command, {}};
    for (const CellRecord& cell : now.cells) record.changes.push_back(change_of(now, cell, before));
    return record;
}

}  // namespace aoscore
