#include "experiment/experiment.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "core/staged_folder.h"
#include "core/threads.h"
#include "experiment/baseline.h"
#include "experiment/live_output.h"
#include "experiment/machine.h"
#include "experiment/rankings.h"
#include "experiment/view_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

namespace aoscore {
namespace {

constexpr double kAutomaticRadiusShare = 0.02;

/// One picture to be measured, with everything its plan names looked up.
struct PreparedView {
    const ViewPlan* plan;
    std::size_t plan_index;  ///< into ExperimentPlan::views
    std::shared_ptr<const Scene> scene;
    const View* view;
    std::vector<ResolvedCell> cells;
};

// Looks up and loads everything before any work is done or file is written, so that a wrong name costs
// nothing.
std::vector<PreparedView> prepare(const ExperimentPlan& plan, const Registry& registry) {
    std::map<std::string, std::shared_ptr<const Scene>> scenes;
    std::vector<std::vector<ResolvedCell>> cells;
    for (const ViewPlan& view : plan.views) {
        cells.emplace_back();
        for (const CellPlan& cell : view.cells) cells.back().push_back(resolve(cell, registry, plan.seed));
    }
    std::vector<PreparedView> prepared;
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const ViewPlan& wanted = plan.views[i];
        std::shared_ptr<const Scene>& scene = scenes[wanted.scene];
        if (!scene) {
            scene = std::make_shared<Scene>(load_scene(wanted.scene));
            for (const std::string& warning : scene->warnings) log_warning(scene->id + ": " + warning);
        }
        const auto add = [&](const View& view) {
            CameraFrame(view.camera, wanted.width, wanted.height);
            prepared.push_back({&wanted, i, scene, &view, cells[i]});
        };
        if (wanted.view.empty()) {
            for (const View& view : scene->views) add(view);
        } else {
            add(find_view(*scene, wanted.view));
        }
    }
    return prepared;
}

// Names the view in the results. One view in two sizes is two entries.
std::string view_key(const PreparedView& p, const Results& results) {
    const std::string key = p.scene->id + "/" + p.view->id;
    const bool taken = std::any_of(results.views.begin(), results.views.end(),
                                   [&](const ViewRecord& view) { return view.key == key; });
    return taken ? fmt::format("{}@{}x{}", key, p.plan->width, p.plan->height) : key;
}

}  // namespace

double ranking_radius(const std::optional<double>& asked, const View& view, const Scene& scene,
                      std::vector<std::string>& warnings) {
    if (asked) return *asked;
    if (view.radius_m) return *view.radius_m;
    const double radius = kAutomaticRadiusShare * scene.bounds.diagonal();
    warnings.push_back(
        fmt::format("no radius is named for view {}; ranked at {:.4g} m, {:g} % of the scene's diagonal",
                    view.id, radius, 100 * kAutomaticRadiusShare));
    return radius;
}

Results run_experiment(const ExperimentPlan& plan, const std::filesystem::path& target,
                       const std::function<void(const std::filesystem::path&)>& finish) {
    const auto start = std::chrono::steady_clock::now();
    const Registry registry = load_registry(plan.methods_dir);
    const std::vector<PreparedView> prepared = prepare(plan, registry);
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

    ScreenRenderer renderer;
    results.gl_renderer = renderer.renderer();
    results.gl_version = renderer.version();
    const Scene* current = nullptr;
    std::unique_ptr<ReferenceScene> reference;
    std::map<std::string, CameraFrame> frames;
    std::vector<std::vector<std::string>> cell_ids(plan.views.size());
    for (const PreparedView& p : prepared) {
        if (p.scene.get() != current) {
            current = p.scene.get();
            reference = std::make_unique<ReferenceScene>(*current);
            renderer.set_scene(*current);
        }
        const std::string key = view_key(p, results);
        log_info(fmt::format("{}: {} triangles, {}x{}", key, current->triangle_count, p.plan->width,
                             p.plan->height));
        ViewOutcome outcome = run_view({*p.scene, *p.view, *reference, renderer, *p.plan, p.cells, key,
                                        plan.seed, results.mask_threshold, plan.keep_gbuffer,
                                        plan.truth_cache, plan.command, gbuffer_inputs_of(registry), folder});
        frames.emplace(key, CameraFrame(p.view->camera, p.plan->width, p.plan->height));
        for (CellRecord& cell : outcome.cells) {
            cell_ids[p.plan_index].push_back(cell.id);
            if (!cell.error.empty()) log_warning("failed: " + cell.id + ": " + cell.error);
            results.cells.push_back(std::move(cell));
        }
        results.views.push_back(std::move(outcome.view));
    }
    results.rankings = rank(results.cells, plan.seed);
    if (plan.baseline) results.baseline = against_baseline(results, *plan.baseline);
    for (const TablePlan& table : plan.tables) {
        TableRecord record{table.definition, {}};
        for (const std::size_t index : table.cell_indices)
            record.cell_ids.push_back(cell_ids[table.view_index][index]);
        results.tables.push_back(std::move(record));
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    results.total_seconds = elapsed.count();
    results.peak_memory_mib = peak_memory_mib();
    write_results(results, folder);
    write_live_file(folder, registry, frames, plan.seed);
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
