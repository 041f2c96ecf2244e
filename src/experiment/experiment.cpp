#include "experiment/experiment.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/staged_folder.h"
#include "core/threads.h"
#include "experiment/baseline.h"
#include "experiment/claims/judge.h"
#include "experiment/live_output.h"
#include "experiment/rankings.h"
#include "experiment/scene_views.h"
#include "experiment/view_run.h"
#include "experiment/view_stock.h"
#include "experiment/work_plan.h"
#include "results/sweep_rows.h"
#include "scene/view_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <span>
#include <utility>

namespace aoscore {
namespace {

/// One picture to be measured, with everything its plan names looked up.
struct PreparedView {
    const ViewPlan* plan;
    std::size_t plan_index;  ///< into ExperimentPlan::views
    std::shared_ptr<const Scene> scene;
    View view;
    RankingRadius radius;
    std::vector<ResolvedCell> cells;
};

/// The radius that lengths are drawn for; empty where the plan wants them as descriptors have them.
std::optional<double> drawn_for(const ExperimentPlan& plan, const RankingRadius& radius) {
    return plan.own_parameters ? std::nullopt : std::optional(radius.metres);
}

/// The scenes of a plan, each read once.
class PlannedScenes {
  public:
    std::shared_ptr<const Scene> of(const ViewPlan& plan) {
        for (const auto& [reader, scene] : scenes_) {
            if (reader->scene == plan.scene && reader->load == plan.load) return scene;
        }
        auto scene = std::make_shared<const Scene>(load_scene(plan.scene, plan.load));
        for (const std::string& warning : scene->warnings) log_warning(scene->id + ": " + warning);
        if (plan.view.empty()) {
            if (const std::string left_out = left_out_text(*scene); !left_out.empty()) log_info(left_out);
        }
        scenes_.emplace_back(&plan, scene);
        return scene;
    }

  private:
    std::vector<std::pair<const ViewPlan*, std::shared_ptr<const Scene>>> scenes_;
};

// Looks up and loads everything before any work is done or file is written, so that a wrong name costs
// nothing.
std::vector<PreparedView> prepare(const ExperimentPlan& plan, const Registry& registry,
                                  const MeasurementStore& store) {
    for (const ViewPlan& view : plan.views) {
        for (const CellPlan& cell : view.cells) resolve(cell, registry, plan.seed, std::nullopt);
    }
    PlannedScenes scenes;
    std::vector<PreparedView> prepared;
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const ViewPlan& wanted = plan.views[i];
        const std::shared_ptr<const Scene> scene = scenes.of(wanted);
        const double aspect = static_cast<double>(wanted.width) / wanted.height;
        RankingRadii radii(*scene);
        for (View& view : wanted_views(*scene, wanted.load, wanted.view, aspect, store)) {
            CameraFrame(view.camera, wanted.width, wanted.height);
            PreparedView p{&wanted, i, scene, view, radii.of(wanted.radius_m, view), {}};
            if (p.radius.automatic) log_warning(scene->id + ": " + radius_warning(p.radius, view));
            for (const CellPlan& cell : wanted.cells)
                p.cells.push_back(resolve(cell, registry, plan.seed, drawn_for(plan, p.radius)));
            prepared.push_back(std::move(p));
        }
    }
    // A scene is built once: its views one after the other.
    std::vector<const Scene*> order;
    for (const PreparedView& p : prepared) {
        if (std::find(order.begin(), order.end(), p.scene.get()) == order.end())
            order.push_back(p.scene.get());
    }
    std::stable_sort(prepared.begin(), prepared.end(), [&](const PreparedView& a, const PreparedView& b) {
        return std::find(order.begin(), order.end(), a.scene.get()) <
               std::find(order.begin(), order.end(), b.scene.get());
    });
    return prepared;
}

// Names the view in the results. One view in two sizes, or at two radii, is two entries.
std::string view_key(const PreparedView& p, const std::vector<std::string>& taken) {
    const auto is_taken = [&](const std::string& key) {
        return std::ranges::find(taken, key) != taken.end();
    };
    const std::string key = p.scene->id + "/" + p.view.id;
    if (!is_taken(key)) return key;
    const std::string with_size = fmt::format("{}@{}x{}", key, p.plan->width, p.plan->height);
    return is_taken(with_size) ? fmt::format("{}@{:g}m", with_size, p.radius.metres) : with_size;
}

/// The ids of a plan's cells, by its view, then by the scene's views that it stands for, then by cell.
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
    if (plan.claim_ids.empty()) return {};
    std::vector<ClaimList> lists = chosen_claims(load_claims(), plan.claim_ids);
    scale_views(lists, plan.claim_scale);
    return lists;
}

}  // namespace

Results run_experiment(const ExperimentPlan& plan, const std::filesystem::path& target,
                       const std::function<void(const std::filesystem::path&)>& finish) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::string> left_out;  // the plan says which: it names none of them
    const Registry registry = load_registry(plan.methods_dir, {}, left_out);
    const MeasurementStore store(MeasurementStore::folder_in(plan.truth_cache));
    const std::vector<PreparedView> prepared = prepare(plan, registry, store);
    const std::vector<ClaimList> claims = planned_claims(plan);
    // Opened before the work begins: a path that cannot be written fails at once.
    StagedFolder staged(target);
    const std::filesystem::path& folder = staged.path();

    Results results;
    results.program_version = version();
    results.created_utc = utc_now();
    results.command = plan.command;
    results.warnings = plan.warnings;
    for (const std::string& warning : plan.warnings) log_warning(warning);
    results.cpu = cpu_name();
    results.threads = thread_count();
    results.seed = plan.seed;

    SceneTools tools;
    results.gl_renderer = tools.renderer().renderer();
    results.gl_version = tools.renderer().version();
    std::map<std::string, LiveView> live_views;
    std::vector<std::string> keys;
    std::vector<ViewRun> runs;
    std::vector<ViewStock> stocks;
    for (const PreparedView& p : prepared) {
        keys.push_back(view_key(p, keys));
        const std::optional<double> radius_m = drawn_for(plan, p.radius);
        live_views.emplace(keys.back(),
                           LiveView{CameraFrame(p.view.camera, p.plan->width, p.plan->height), radius_m});
        runs.push_back({*p.scene, p.view, tools, *p.plan, p.radius, radius_m, p.cells, registry.fixed_pass,
                        registry.lighting, keys.back(), plan.seed, results.mask_threshold, plan.keep_gbuffer,
                        plan.truth_cache, plan.command, gbuffer_inputs_of(registry), folder});
        stocks.push_back(take_stock(runs.back(), store));
    }
    WorkPlan work = plan_work(runs, stocks, store);
    log_info(work.text());
    CellIds cell_ids(plan.views.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ViewRun& run = runs[i];
        tools.choose(run.scene);
        if (!stocks[i].complete()) {
            log_info(fmt::format("{}: {} triangles, {}x{}", run.key, run.scene.triangle_count, run.plan.width,
                                 run.plan.height));
        }
        const auto view_start = std::chrono::steady_clock::now();
        ViewOutcome outcome = run_view(run, store, stocks[i]);
        const std::chrono::duration<double> view_time = std::chrono::steady_clock::now() - view_start;
        learn_pace(store, run, outcome, view_time.count());
        if (!work.seconds && i + 1 < runs.size()) {
            work = plan_work(std::span(runs).subspan(i + 1), std::span(stocks).subspan(i + 1), store);
            if (work.seconds) log_info(work.rest_text());
        }
        results.work.rays += outcome.rays;
        results.work.cells_measured += outcome.measured;
        results.work.cells_reused += run.cells.size() - outcome.measured;
        auto& ids = cell_ids[prepared[i].plan_index].emplace_back();
        for (CellRecord& cell : outcome.cells) {
            ids.push_back(cell.id);
            if (!cell.error.empty()) log_warning("failed: " + cell.id + ": " + cell.error);
            results.cells.push_back(std::move(cell));
        }
        results.views.push_back(std::move(outcome.view));
    }
    const ScreenRenderer::Work drawn = tools.renderer().work();
    results.work.gbuffers = drawn.gbuffers;
    results.work.passes = drawn.passes;
    results.work.compilations = drawn.compilations;
    std::vector<CellRecord> pictured;
    std::copy_if(results.cells.begin(), results.cells.end(), std::back_inserter(pictured),
                 [](const CellRecord& cell) { return !cell.image_file.empty(); });
    results.rankings = rank(results.views, pictured, plan.seed);
    if (plan.baseline) results.baseline = against_baseline(results, *plan.baseline);
    for (const TablePlan& table : plan.tables) {
        TableRecord record{table.definition, {}};
        for (const std::size_t index : table.cell_indices)
            record.cell_ids.push_back(cell_ids[table.view_index].front()[index]);
        results.tables.push_back(std::move(record));
    }
    for (const SweepPlan& sweep : plan.sweeps) results.sweeps.push_back(sweep_record(sweep, cell_ids));
    if (!claims.empty()) results.claims = judge_claims(claims, results);
    for (const ClaimRecord& claim : results.claims) log_info(verdict_text(claim));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    results.total_seconds = elapsed.count();
    results.peak_memory_mib = peak_memory_mib();
    write_results(results, folder);
    if (!pictured.empty()) write_live_file(folder, registry, plan.methods_dir, live_views, plan.seed);
    if (!results.sweeps.empty()) write_atomically(folder / "sweep.csv", sweeps_as_csv(results));
    if (finish) finish(folder);
    staged.publish();
    return results;
}

std::size_t failed_cells(const Results& results) {
    std::size_t count = 0;
    for (const CellRecord& cell : results.cells) count += !cell.error.empty();
    return count;
}

}  // namespace aoscore
