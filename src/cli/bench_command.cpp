#include "bench/bench_compare.h"
#include "bench/bench_main.h"
#include "bench/bench_methods.h"
#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/output.h"
#include "core/stopwatch.h"
#include "page/page.h"
#include "reference/benchmark/benchmark.h"
#include "results/results_folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace aoscore {
namespace {

struct BenchOptions {
    std::string name;
    std::string scene = "atrium";
    ViewChoice view;
    std::vector<std::string> methods;
    std::filesystem::path methods_dir;
    std::filesystem::path results;
};

void bench_reference(const BenchOptions& options) {
    const Scene scene = load_with_warnings(options.scene, options.view.load);
    reference_benchmark(scene, one_view(scene, options.view, {}), {});
}

void bench_methods(const BenchOptions& options, const GlobalOptions& global) {
    const Scene scene = load_with_warnings(options.scene, options.view.load);
    MethodsBenchmark benchmark;
    benchmark.seed = global.seed;
    benchmark.methods = options.methods;
    benchmark.methods_dir = options.methods_dir;
    bench_methods(scene, one_view(scene, options.view, {}), benchmark);
}

void bench_metrics_and_page(const BenchOptions& options, const GlobalOptions& global) {
    bench_compare(global.seed);
    const std::filesystem::path folder = results_folder(options.results, "main");
    if (!std::filesystem::exists(folder / "results.json")) {
        print_result("{:<30} {:>8}  no results in {}; aoscore run makes them\n", "page from results", "-",
                     folder.string());
        return;
    }
    const Stopwatch watch;
    const std::filesystem::path page = write_page(folder);
    print_result("{:<30} {:>8.1f} ms  {:.1f} MiB, {}\n", "page from results", 1000 * watch.seconds(),
                 static_cast<double>(std::filesystem::file_size(page)) / (1 << 20), page.string());
}

using Bench = void (*)(const BenchOptions&, const GlobalOptions&);

const std::map<std::string, Bench>& benches() {
    static const std::map<std::string, Bench> table{
        {"compare", [](const BenchOptions& options,
                       const GlobalOptions& global) { bench_metrics_and_page(options, global); }},
        {"main", [](const BenchOptions&, const GlobalOptions& global) { bench_main(global.seed); }},
        {"methods",
         [](const BenchOptions& options, const GlobalOptions& global) { bench_methods(options, global); }},
        {"reference", [](const BenchOptions& options, const GlobalOptions&) { bench_reference(options); }},
    };
    return table;
}

}  // namespace

CommandEntry add_bench_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app =
        program.add_subcommand("bench", "Measure speed and memory; prints ratios against named baselines");
    const auto options = std::make_shared<BenchOptions>();
    std::vector<std::string> names;
    for (const auto& [id, bench] : benches()) names.push_back(id);
    app->add_option("name", options->name,
                    "compare: metrics beside scikit-image, and the page; main: the main job, cold; methods: "
                    "their shaders, specialised and with uniforms; "
                    "reference: the ray tracer")
        ->required()
        ->check(one_of(names));
    app->add_option("scene", options->scene, "For methods, reference: a scene")->capture_default_str();
    add_view_options(*app, options->view);
    app->add_option("--methods", options->methods, "For methods: only these [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--methods-dir", options->methods_dir, "For methods: a folder of methods of your own");
    app->add_option("--results", options->results,
                    "For compare: results to build the page of [reports/out/main]");
    return {app, [options, &global] {
                benches().at(options->name)(*options, global);
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
