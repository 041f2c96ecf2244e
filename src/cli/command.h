#pragma once

#include "core/error.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace aoscore {

/// Options that every subcommand takes.
struct GlobalOptions {
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: all cores
    bool quiet = false;
    std::string gl;                  ///< empty: what AOSCORE_GL says
    std::string node_kind;           ///< whose times count; empty: this machine's own
    std::string command_line;        ///< as the user gave it, quoted for a shell
    std::vector<std::string> words;  ///< its words, without the program's name
};

/// The function of a subcommand, which runs where the command line names it.
using Command = std::function<ExitCode()>;
struct CommandEntry {
    CLI::App* app;
    Command run;
};
using AddCommand = CommandEntry (*)(CLI::App& program, const GlobalOptions& global);

CommandEntry add_run_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_score_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_sweep_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_tune_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_worst_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_export_training_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_claims_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_reference_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_gbuffer_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_compare_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_page_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_index_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_list_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_stress_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_bench_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_cache_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_job_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_plan_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_work_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_schema_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_manual_command(CLI::App& program, const GlobalOptions& global);
CommandEntry add_completion_command(CLI::App& program, const GlobalOptions& global);

}  // namespace aoscore
