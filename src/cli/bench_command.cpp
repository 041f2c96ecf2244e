#include "cli/command.h"
#include "experiment/bench_main.h"

#include <fmt/format.h>

#include <map>
#include <memory>

namespace aoscore {
namespace {

using Bench = void (*)(const GlobalOptions&);

const std::map<std::string, Bench>& benches() {
    static const std::map<std::string, Bench> table{
        {"main", [](const GlobalOptions& global) { bench_main(global.seed); }},
    };
    return table;
}

}  // namespace

CommandEntry add_bench_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app =
        program.add_subcommand("bench", "Measure speed and memory; prints ratios against named baselines");
    const auto name = std::make_shared<std::string>();
    std::vector<std::string> names;
    for (const auto& [id, bench] : benches()) names.push_back(id);
    app->add_option("name", *name, "Which benchmark")->required()->check(CLI::IsMember(names));
    return {app, [name, &global] {
                benches().at (*name)(global);
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
