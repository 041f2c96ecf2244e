#include "cli/command.h"
#include "cli/job_options.h"
#include "cli/shared_options.h"
#include "jobs/work_parts.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {
namespace {

constexpr const char* kExample = "plan --parts 8 --out plan.json score atrium --samples 64";

struct PlanOptions {
    std::size_t parts = 0;
    std::filesystem::path out;
};

struct WorkOptions {
    std::filesystem::path plan;
    std::size_t part = 0;
};

ExitCode plan(const PlanOptions& options, const std::vector<std::string>& command) {
    if (command.empty())
        throw usage_error("the command to divide is missing", "plan",
                          fmt::format("for example: {}", kExample));
    return run_division(command, options.out, options.parts);
}

ExitCode work(const WorkOptions& options, const GlobalOptions& global) {
    const WorkParts work = read_parts(options.plan);
    // An array of a cluster may have more tasks than there was work for.
    if (options.part > work.parts.size()) {
        log_info(
            fmt::format("There are {} parts: nothing is left for part {}", work.parts.size(), options.part));
        return ExitCode::ok;
    }
    return run_jobs(work.command, work.parts[options.part - 1].keys, global);
}

}  // namespace

CommandEntry add_plan_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand(
        "plan",
        "Divide the work of a command, which follows the options, into parts for many processes or machines");
    app->footer(
        fmt::format("Example: aoscore {}\nThen, in as many processes: aoscore work plan.json --part 1 "
                    "(to 8), and at last the command itself.",
                    kExample));
    const auto options = std::make_shared<PlanOptions>();
    app->add_option("--parts", options->parts,
                    "How many, of even estimated cost; fewer where there is less to do")
        ->required()
        ->check(CLI::Range(1, 100000));
    app->add_option("--out", options->out, "The file for the plan, JSON")->required();
    app->prefix_command();
    app->fallthrough(false);  // what follows belongs to the command that is divided
    return {app, [options, app] { return plan(*options, app->remaining()); }};
}

CommandEntry add_work_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "work",
        "Do one part of a plan and keep its results in the cache, where the planned command finds them");
    const auto options = std::make_shared<WorkOptions>();
    app->add_option("plan", options->plan, "What plan wrote")->required();
    app->add_option("--part", options->part,
                    "Which of its parts, from 1; one beyond the last has nothing to do")
        ->required()
        ->check(CLI::Range(1, 100000));
    return {app, [options, &global] { return work(*options, global); }};
}

}  // namespace aoscore
