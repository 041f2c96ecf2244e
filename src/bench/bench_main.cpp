#include "bench/bench_main.h"

#include "core/machine.h"
#include "core/output.h"
#include "core/stopwatch.h"
#include "experiment/experiment.h"
#include "results/results_folder.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <fmt/format.h>

#include <filesystem>

namespace aoscore {
namespace {

/// Truth rays a pixel.
constexpr int kSamples = 64;

void print_row(const char* what, double seconds, double total_seconds) {
    print_result("{:<44} {:>8.2f} s {:>7.1f} %\n", what, seconds, 100 * seconds / total_seconds);
}

double reading_and_gbuffer_seconds() {
    const Stopwatch watch;
    const Scene scene = load_scene("atrium");
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(CameraFrame(find_view(scene, "wide").camera, 1920, 1080), {"normal_geometric"});
    return watch.seconds();
}

}  // namespace

void bench_main(std::uint64_t seed) {
    const double gbuffer_s = reading_and_gbuffer_seconds();
    std::vector<std::string> ids;
    for (const ExperimentDefinition& experiment : list_experiments()) {
        if (experiment.kind == ExperimentDefinition::Kind::table) ids.push_back(experiment.id);
    }
    ExperimentPlan plan = plan_experiments(ids);
    plan.seed = seed;
    plan.command = "aoscore bench main";
    // Its own settings, so that figures of different days compare: every ray is traced, none comes from the
    // cache, and as many for every pixel.
    for (ViewPlan& view : plan.views) {
        view.samples = kSamples;
        view.max_error = 0;
    }
    const std::filesystem::path folder = results_folder({}, "bench-main");
    std::filesystem::remove_all(folder);
    const Stopwatch watch;
    const Results results = run_experiment(plan, folder);
    const double total_s = watch.seconds();

    double truth_s = 0, timed_s = 0;
    for (const ViewRecord& view : results.views) truth_s += view.truth_seconds;
    for (const CellRecord& cell : results.cells) {
        for (const double ms : cell.ao.runs_ms) timed_s += ms / 1000;
        for (const double ms : cell.filter_pass.runs_ms) timed_s += ms / 1000;
    }
    print_result("{}, {} threads, {}\n", results.cpu, results.threads, results.gl_renderer);
    print_row(fmt::format("main job without its page, cold, {} rays a pixel", kSamples).c_str(), total_s,
              total_s);
    print_row("  tracing the truths", truth_s, total_s);
    print_row("  timed runs of the methods", timed_s, total_s);
    print_row("  everything else", total_s - truth_s - timed_s, total_s);
    print_row("reading and first G-buffer of the atrium", gbuffer_s, total_s);
    print_result("{:<44} {:>8.0f} MiB\n", "peak memory", peak_memory_mib());
    for (const ViewRecord& view : results.views) {
        print_result("{:<44} {:>8.1f} million rays a second\n", "truth " + view.key,
                     static_cast<double>(view.truth_rays) / view.truth_seconds / 1e6);
    }
}

}  // namespace aoscore
