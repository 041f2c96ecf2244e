#include "bench/bench_compare.h"
#include "bench/bench_layers.h"
#include "bench/bench_main.h"
#include "bench/bench_methods.h"
#include "bench/cost.h"
#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/files.h"
#include "core/machine.h"
#include "core/output.h"
#include "core/ratio_table.h"
#include "core/threads.h"
#include "page/page.h"
#include "reference/benchmark/benchmark.h"
#include "results/results.h"
#include "results/results_folder.h"
#include "store/code_digest.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
    std::filesystem::path json;
};

void bench_reference(const BenchOptions& options, const GlobalOptions&, RatioTable& table) {
    const Scene scene = load_with_warnings(options.scene, options.view.load);
    reference_benchmark(scene, one_view(scene, options.view, {}), {}, table);
}

void bench_methods(const BenchOptions& options, const GlobalOptions& global, RatioTable& table) {
    const Scene scene = load_with_warnings(options.scene, options.view.load);
    MethodsBenchmark benchmark;
    benchmark.seed = global.seed;
    benchmark.methods = options.methods;
    benchmark.methods_dir = options.methods_dir;
    bench_methods(scene, one_view(scene, options.view, {}), benchmark, table);
}

void bench_layers(const BenchOptions& options, const GlobalOptions& global, RatioTable& table) {
    const Scene scene = load_with_warnings(options.scene, options.view.load);
    bench_layers(scene, one_view(scene, options.view, {}), global.seed, table);
}

void write_changed_page(const std::filesystem::path& staged, const std::filesystem::path& folder) {
    write_page_unless_shown(staged, folder / "index.html", std::string(code_digest("page")));
}

void bench_main(const BenchOptions&, const GlobalOptions& global, RatioTable& table) {
    bench_main(global.seed, write_changed_page, table);
}

void bench_compare(const BenchOptions& options, const GlobalOptions& global, RatioTable& table) {
    bench_compare_files(global.seed, table);  // First, while little memory is in use.
    bench_compare(global.seed, table);
    const std::filesystem::path folder = results_folder(options.results, "main");
    if (!std::filesystem::exists(folder / "results.json")) {
        print_result("no page: there are no results in {}; aoscore run makes them\n", folder.string());
        return;
    }
    std::filesystem::path page;
    const Cost cost = cost_of([&] { page = write_page(folder); });
    table.add("page from results", cost.processor_s, "processor s");
    table.add("size of the page", static_cast<double>(std::filesystem::file_size(page)) / (1 << 20), "MiB");
}

using Bench = void (*)(const BenchOptions&, const GlobalOptions&, RatioTable&);

const std::map<std::string, Bench>& benches() {
    static const std::map<std::string, Bench> table{{"compare", bench_compare},
                                                    {"layers", bench_layers},
                                                    {"main", bench_main},
                                                    {"methods", bench_methods},
                                                    {"reference", bench_reference}};
    return table;
}

void run_bench(const BenchOptions& options, const GlobalOptions& global) {
    RatioTable table;
    benches().at(options.name)(options, global, table);
    table.print();
    if (options.json.empty()) return;
    const nlohmann::json file = {{"benchmark", options.name}, {"program_version", version()},
                                 {"created_utc", utc_now()},  {"cpu", cpu_name()},
                                 {"threads", thread_count()}, {"rows", table.json()}};
    write_atomically(options.json, file.dump(2) + "\n");
}

}  // namespace

CommandEntry add_bench_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app =
        program.add_subcommand("bench", "Measure speed and memory; prints ratios against named baselines");
    const auto options = std::make_shared<BenchOptions>();
    std::vector<std::string> names;
    for (const auto& [id, bench] : benches()) names.push_back(id);
    app->add_option("name", options->name,
                    "compare: metrics beside a plain pass and scikit-image, whole compares beside idiff, the "
                    "page; layers: passes of depth layers beside plain ones, and what methods find by them; "
                    "main: the main job's stages, cold and warm; methods: their shaders beside a pass "
                    "of depth alone; reference: the ray tracer beside bare Embree and plain Monte Carlo")
        ->required()
        ->check(one_of(names));
    app->add_option("scene", options->scene, "For layers, methods, reference: a scene")
        ->capture_default_str();
    add_view_options(*app, options->view);
    app->add_option("--methods", options->methods, "For methods: only these [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--methods-dir", options->methods_dir, "For methods: a folder of methods of your own");
    app->add_option("--results", options->results,
                    "For compare: results to build the page of [reports/out/main]");
    app->add_option("--json", options->json, "Write the rows to this file, too");
    return {app, [options, &global] {
                run_bench(*options, global);
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
