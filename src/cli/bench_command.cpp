#include "cli/command.h"
#include "cli/shared_options.h"
#include "experiment/bench_main.h"
#include "reference/benchmark.h"

#include <map>
#include <memory>

namespace aoscore {
namespace {

struct Options {
    std::string name;
    std::string scene = "atrium";
    std::string view;
};

void bench_reference(const Options& options) {
    const Scene scene = load_with_warnings(options.scene);
    reference_benchmark(scene, one_view(scene, options.view), {});
}

using Bench = void (*)(const Options&, const GlobalOptions&);

const std::map<std::string, Bench>& benches() {
    static const std::map<std::string, Bench> table{
        {"main", [](const Options&, const GlobalOptions& global) { bench_main(global.seed); }},
        {"reference", [](const Options& options, const GlobalOptions&) { bench_reference(options); }},
    };
    return table;
}

}  // namespace

CommandEntry add_bench_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app =
        program.add_subcommand("bench", "Measure speed and memory; prints ratios against named baselines");
    const auto options = std::make_shared<Options>();
    std::vector<std::string> names;
    for (const auto& [id, bench] : benches()) names.push_back(id);
    app->add_option("name", options->name, "main: the main job, cold; reference: the ray tracer")
        ->required()
        ->check(CLI::IsMember(names));
    app->add_option("scene", options->scene, "For reference: a scene")->capture_default_str();
    app->add_option("--view", options->view, "For reference: a view of it [the first]");
    return {app, [options, &global] {
                benches().at(options->name)(*options, global);
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
