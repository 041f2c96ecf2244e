#include "experiment/experiment.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/node_kind.h"
#include "core/staged_folder.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "experiment/left_files.h"
#include "experiment/planned_runs.h"
#include "experiment/score_goal.h"
#include "experiment/work_plan.h"
#include "metrics/analysis/repeat_values.h"
#include "plan/live_output.h"
#include "results/sweep_rows.h"
#include "verdict/advice.h"
#include "verdict/baseline.h"
#include "verdict/claim_verdicts.h"
#include "verdict/rankings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace aoscore {
namespace {

/// The ids of cells, by the plan's view, then by the scene's views that it stands for, then by cell.
using CellIds = std::vector<std::vector<std::vector<std::string>>>;

SweepRecord sweep_record(const SweepPlan& sweep, const CellIds& cell_ids) {
    SweepRecord record;
    record.definition = sweep.definition;
    record.title = sweep.title;
    record.axes = sweep.axes;
    record.budget_ms = sweep.budget_ms;
    record.timing_confidence = TimingGoal().confidence;
    record.notes = sweep.notes;
    for (const SweepPoint& point : sweep.points) {
        for (const std::vector<std::string>& ids : cell_ids[point.view_index])
            record.points.push_back({ids[point.cell_index], point.at});
    }
    return record;
}

std::vector<ClaimList> planned_claims(const ExperimentPlan& plan) {
    // A first answer times nothing, and most claims are about times.
    if (plan.claim_ids.empty() || plan.first_answer) return {};
    std::vector<ClaimList> lists = chosen_claims(load_claims(), plan.claim_ids);
    scale_views(lists, plan.claim_scale);
    return lists;
}

/// The run of one plan: its views one after the other, then rankings, claims and all else over views.
class ExperimentRun {
  public:
    /// `watch` has run since the work began.
    ExperimentRun(const ExperimentPlan& plan, PlannedRuns& planned, const ArtifactStore& store,
                  const Stopwatch& watch)
        : watch_(watch), plan_(plan), planned_(planned), store_(store), cell_ids_(plan.views.size()) {}

    Results run() {
        describe();
        measure_views();
        count_work();
        judge_steps();
        judge();
        results_.total_seconds = watch_.seconds();
        results_.peak_memory_mib = peak_memory_mib();
        return std::move(results_);
    }

  private:
    void describe() {
        results_.program_version = version();
        results_.created_utc = utc_now();
        results_.command = plan_.command;
        results_.warnings = plan_.warnings;
        for (const std::string& warning : plan_.warnings) log_warning(warning);
        results_.cpu = machine_name();
        results_.threads = thread_count();
        results_.seed = plan_.seed;
        results_.gl_renderer = planned_.tools().renderer().renderer();
        results_.gl_version = planned_.tools().renderer().version();
    }

    void measure_views() {
        const std::span<const ViewRun> runs = planned_.runs();
        WorkPlan work = plan_work(runs, store_);
        log_info(work.text());
        for (std::size_t i = 0; i < runs.size(); ++i) {
            measure_view(i);
            if (work.seconds || i + 1 == runs.size()) continue;
            work = plan_work(runs.subspan(i + 1), store_);
            if (work.seconds) log_info(work.rest_text());
        }
    }

    void measure_view(std::size_t i) {
        const ViewRun& run = planned_.runs()[i];
        planned_.tools().choose(run.work.scene);
        if (!is_known(run, store_)) {
            const std::string what = run.work.recorded != nullptr
                                         ? "a frame without its scene"
                                         : fmt::format("{} triangles", run.work.scene.triangle_count);
            log_info(fmt::format("{}: {}, {}x{}", run.work.key, what, run.work.width, run.work.height));
        }
        const Stopwatch watch;
        ViewOutcome outcome = run_to_goal(run, store_);
        learn_pace(store_, run, outcome, watch.seconds());
        results_.work.rays += outcome.rays;
        results_.work.cells_measured += outcome.measured;
        results_.work.cells_reused += run.cells.size() - outcome.measured;
        auto& ids = cell_ids_[planned_.prepared()[i].plan_index].emplace_back();
        for (CellRecord& cell : outcome.cells) {
            ids.push_back(cell.id);
            if (!cell.error.empty()) log_warning("failed: " + cell.id + ": " + cell.error);
            results_.cells.push_back(std::move(cell));
        }
        results_.views.push_back(std::move(outcome.view));
    }

    void count_work() {
        const ScreenRenderer::Work drawn = planned_.tools().renderer().work();
        results_.work.gbuffers = drawn.gbuffers;
        results_.work.passes = drawn.passes;
        results_.work.compilations = drawn.compilations;
    }

    /// The cells of a table's rows, and what the step to the tuned preset brings each.
    TableRecord table_record(const TablePlan& table) const {
        const std::vector<std::string>& ids = cell_ids_[table.view_index].front();
        TableRecord record;
        record.definition = table.definition;
        for (const std::size_t index : table.cell_indices) record.cell_ids.push_back(ids[index]);
        for (const TunedRowPlan& row : table.tuned)
            record.tuned.push_back({judge_advice(row.step, ids, results_), row.tuning});
        return record;
    }

    /// Judges the steps, whose cells then leave the results: they are no contestants.
    void judge_steps() {
        for (const TablePlan& table : plan_.tables) results_.tables.push_back(table_record(table));
        for (const AdvicePlan& advice : plan_.advice) {
            for (const std::vector<std::string>& ids : cell_ids_[advice.view_index])
                results_.advice.push_back(judge_advice(advice, ids, results_));
        }
        std::set<std::string> steps;
        for (std::size_t v = 0; v < plan_.views.size(); ++v) {
            for (const std::vector<std::string>& ids : cell_ids_[v]) {
                for (std::size_t c = 0; c < ids.size(); ++c) {
                    if (plan_.views[v].cells[c].step) steps.insert(ids[c]);
                }
            }
        }
        std::erase_if(results_.cells, [&](const CellRecord& cell) { return steps.contains(cell.id); });
    }

    void judge() {
        std::vector<CellRecord> pictured;
        std::ranges::copy_if(results_.cells, std::back_inserter(pictured),
                             [](const CellRecord& cell) { return !cell.image_file.empty(); });
        results_.rankings = rank(results_.views, pictured, plan_.seed);
        if (plan_.baseline) results_.baseline = against_baseline(results_, *plan_.baseline);
        for (const SweepPlan& sweep : plan_.sweeps) results_.sweeps.push_back(sweep_record(sweep, cell_ids_));
        const std::vector<ClaimList> claims = planned_claims(plan_);
        if (!claims.empty()) results_.claims = judge_claims(claims, results_);
        for (const ClaimRecord& claim : results_.claims) log_info(verdict_text(claim));
        // Only the intervals of claims need each block, and the store keeps them.
        for (CellRecord& cell : results_.cells) {
            if (cell.repeats) cell.repeats = over_all_blocks(std::move(*cell.repeats));
        }
    }

    const Stopwatch& watch_;
    const ExperimentPlan& plan_;
    PlannedRuns& planned_;
    const ArtifactStore& store_;
    CellIds cell_ids_;
    Results results_;
};

std::map<std::string, LiveView> live_views(const PlannedRuns& planned) {
    std::map<std::string, LiveView> views;
    for (const ViewRun& run : planned.runs())
        views.emplace(run.work.key, LiveView{run.work.frame(), run.drawn_for_m, run.work.keeps_surfaces()});
    return views;
}

/// A budget chooses by times: it is refused where some may not be taken here and are not kept either.
void require_times_of_budgets(const ExperimentPlan& plan, std::span<const ViewRun> runs,
                              const ArtifactStore& store) {
    const auto has_budget = [](const SweepPlan& sweep) { return sweep.budget_ms.has_value(); };
    const auto is_timed = [&](const CellKeys& keys) { return !keys.times || store.has(keys.times->hex); };
    const auto all_timed = [&](const ViewRun& run) { return std::ranges::all_of(run.jobs.cells, is_timed); };
    if (std::ranges::any_of(plan.sweeps, has_budget) && !std::ranges::all_of(runs, all_timed))
        require_times_here("--budget-ms");
}

}  // namespace

Results run_experiment(const ExperimentPlan& plan, const std::filesystem::path& target,
                       const std::function<void(const std::filesystem::path&)>& finish) {
    const Stopwatch watch;
    const ArtifactStore store(ArtifactStore::folder_in(plan.truth_cache));
    PlannedRuns planned(plan, store);
    planned_claims(plan);  // faults in claims are found before the work begins
    // The folder is opened before the work begins, so that a path that cannot be written fails at once.
    StagedFolder staged(target);
    const std::filesystem::path& folder = staged.path();
    planned.lay_out(folder);
    require_times_of_budgets(plan, planned.runs(), store);
    const bool known =
        std::ranges::all_of(planned.runs(), [&](const ViewRun& r) { return is_scored(r, store); });
    if (plan.first_answer && known) return {};
    const Results results = ExperimentRun(plan, planned, store, watch).run();
    write_results(results, folder);
    const bool pictured =
        std::ranges::any_of(results.cells, [](const CellRecord& cell) { return !cell.image_file.empty(); });
    if (pictured)
        write_live_file(folder, planned.registry(), plan.methods_dir, live_views(planned), plan.seed);
    if (!results.sweeps.empty()) write_atomically(folder / "sweep.csv", sweeps_as_csv(results));
    if (finish) finish(folder);
    const std::set<std::filesystem::path> earlier = pictures_in(target);
    staged.publish();
    remove_left_pictures(target, earlier, results);
    store.settle(folder, target);
    return results;
}

std::size_t failed_cells(const Results& results) {
    std::size_t count = 0;
    for (const CellRecord& cell : results.cells) count += !cell.error.empty();
    return count;
}

}  // namespace aoscore
