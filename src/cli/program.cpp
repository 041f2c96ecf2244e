#include "cli/program.h"

#include "cli/arguments.h"
#include "cli/command.h"
#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/log.h"
#include "core/node_kind.h"
#include "core/output.h"
#include "core/threads.h"
#include "screen/gl/context.h"

#include <fmt/format.h>

#include <array>
#include <sstream>

namespace aoscore {
namespace {

constexpr std::array<AddCommand, 22> kCommands{
    add_run_command,       add_score_command,     add_sweep_command,
    add_tune_command,      add_worst_command,     add_export_training_command,
    add_claims_command,    add_reference_command, add_gbuffer_command,
    add_compare_command,   add_page_command,      add_index_command,
    add_list_command,      add_stress_command,    add_bench_command,
    add_cache_command,     add_job_command,       add_plan_command,
    add_work_command,      add_schema_command,    add_manual_command,
    add_completion_command};

constexpr const char* kFooter =
    "Exit codes: 0 ok, 1 a --warn limit was tripped, 2 a --fail limit was tripped or nothing could be "
    "compared,\n"
    "3 sizes differ, 4 a file cannot be read, understood or written, 5 some cells failed, 64 wrong usage,\n"
    "70 internal or OpenGL failure, 130 interrupted.\n"
    "help COMMAND says more of a command.";

/// Prints a message of CLI11, which ends with a line break of its own.
void complain(std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    if (!text.empty()) log_error(text);
}

}  // namespace

ExitCode run_words(const std::vector<std::string>& words, const std::string& command_line) {
    CLI::App program{
        "aoscore: how far screen-space ambient occlusion is from the ray-traced truth, where, and at what "
        "cost"};
    program.name("aoscore");
    program.set_version_flag("--version",
                             fmt::format("aoscore {}\nbuilt with {}", version(), AOSCORE_LIBRARIES));
    program.require_subcommand(1);
    program.fallthrough();
    program.footer(kFooter);

    GlobalOptions global;
    global.command_line = command_line;
    global.words = words;
    program.add_option("--seed", global.seed, "Of every random choice; the same seed gives the same images")
        ->capture_default_str();
    program
        .add_option("--threads", global.threads,
                    "Threads to use; 0 for all cores. Images do not depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    program.add_option(
        "--gl", global.gl,
        "What draws: osmesa, a software renderer, or egl, or egl:DEVICE by number or a part of its name (see "
        "list devices) [what AOSCORE_GL says, else osmesa]");
    program
        .add_option(
            "--node-kind", global.node_kind,
            "The kind of node whose times count: elsewhere none are taken, and those that are kept are "
            "shown. A machine is of the kind that AOSCORE_NODE_KIND names [this machine's own kind, by "
            "default its processor's name and cores]")
        ->check([](const std::string& kind) { return kind.empty() ? "must not be empty" : ""; });
    program.add_flag("--quiet", global.quiet, "Say nothing but errors and results");

    std::vector<CommandEntry> commands;
    for (const AddCommand add : kCommands) commands.push_back(add(program, global));
    if (words.empty()) {
        complain(program.help());
        return ExitCode::usage;
    }
    try {
        const std::vector<std::string> parsed = without_mark_of_command(program, words);
        std::vector<std::string> last_first(parsed.rbegin(), parsed.rend());
        program.parse(last_first);
    } catch (const CLI::ParseError& e) {
        const bool wrong = e.get_exit_code() != 0;
        if (const std::string unknown = wrong ? unknown_word(program, words) : ""; !unknown.empty())
            throw usage_error(unknown);
        std::ostringstream out, err;
        const int code = program.exit(e, out, err);
        write_output(out.str());
        if (const std::string text = err.str(); !text.empty()) complain("aoscore: " + text);
        return code == 0 ? ExitCode::ok : ExitCode::usage;
    }
    set_quiet(global.quiet);
    set_thread_count(global.threads);
    if (!global.gl.empty()) choose_gl(global.gl);
    choose_node_kind(global.node_kind);
    catch_interrupts();
    for (const CommandEntry& command : commands) {
        if (command.app->parsed()) return command.run();
    }
    throw internal_error("a subcommand was parsed that nobody runs");
}

}  // namespace aoscore
