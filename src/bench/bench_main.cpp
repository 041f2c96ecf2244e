#include "bench/bench_main.h"

#include "core/machine.h"
#include "core/stopwatch.h"
#include "core/temporary_folder.h"
#include "experiment/experiment.h"
#include "results/results_folder.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <string>
#include <vector>

namespace aoscore {
namespace {

/// Truth rays a pixel.
constexpr int kSamples = 64;

double reading_and_gbuffer_seconds() {
    const Stopwatch watch;
    const Scene scene = load_scene("atrium");
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(CameraFrame(find_view(scene, "wide").camera, 1920, 1080), {"normal_geometric"});
    return watch.seconds();
}

ExperimentPlan published_tables(std::uint64_t seed, const std::filesystem::path& cache) {
    std::vector<std::string> ids;
    for (const ExperimentDefinition& experiment : list_experiments()) {
        if (experiment.kind == ExperimentDefinition::Kind::table) ids.push_back(experiment.id);
    }
    ExperimentPlan plan = plan_experiments(ids);
    plan.seed = seed;
    plan.command = "aoscore bench main";
    plan.truth_cache = cache;
    // Its own settings, so that figures of different days compare: as many rays for every pixel.
    for (ViewPlan& view : plan.views) {
        view.samples = kSamples;
        view.max_error = 0;
    }
    return plan;
}

/// Seconds of one run, and of its stages; what is in none of them is drawing, scoring and files.
struct Stages {
    double whole = 0, truths = 0, timed = 0, page = 0;
    double rest() const { return whole - truths - timed - page; }
};

Stages run_once(const ExperimentPlan& plan, const std::filesystem::path& folder,
                const PageWriter& write_page) {
    Stages stages;
    const Stopwatch watch;
    const Results results = run_experiment(plan, folder, [&](const std::filesystem::path& staged) {
        const Stopwatch page;
        write_page(staged, folder);
        stages.page = page.seconds();
    });
    stages.whole = watch.seconds();
    for (const ViewRecord& view : results.views) {
        if (view.truth_rays_now > 0) stages.truths += view.truth_seconds;
    }
    if (results.work.passes == 0) return stages;  // Times were taken from the cache.
    for (const CellRecord& cell : results.cells) {
        for (const Timing* timing : {&cell.ao, &cell.filter_pass}) {
            for (const double ms : timing->runs_ms) stages.timed += ms / 1000;
        }
    }
    return stages;
}

void add_stages(const std::string& run, const Stages& stages, RatioTable& table) {
    table.add(run + ": tracing the truths", stages.truths, "s", run);
    table.add(run + ": timed runs of the methods", stages.timed, "s", run);
    table.add(run + ": the page", stages.page, "s", run);
    table.add(run + ": drawing, scoring, files", stages.rest(), "s", run);
}

}  // namespace

void bench_main(std::uint64_t seed, const PageWriter& write_page, RatioTable& table) {
    const TemporaryFolder cache, results;
    const ExperimentPlan plan = published_tables(seed, cache.path());
    const std::filesystem::path folder = results.path() / "main";
    const Stages cold = run_once(plan, folder, write_page), warm = run_once(plan, folder, write_page);
    const std::string cold_run = "main job, cold", warm_run = "main job, warm";
    table.add(cold_run, cold.whole, "s");
    add_stages(cold_run, cold, table);
    table.add("reading and first G-buffer of the atrium", reading_and_gbuffer_seconds(), "s", cold_run);
    table.add(warm_run, warm.whole, "s", cold_run);
    add_stages(warm_run, warm, table);
    table.add("peak memory", peak_memory_mib(), "MiB");
}

}  // namespace aoscore
