#include "cli/arguments.h"
#include "cli/command.h"
#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/log.h"
#include "core/output.h"
#include "core/shell.h"
#include "core/threads.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

namespace aoscore {
namespace {

constexpr std::array<AddCommand, 12> kCommands{
    add_run_command,       add_score_command,   add_sweep_command,   add_claims_command,
    add_reference_command, add_gbuffer_command, add_compare_command, add_report_command,
    add_list_command,      add_stress_command,  add_bench_command,   add_cache_command};

constexpr const char* kFooter =
    "Exit codes: 0 ok, 1 a --warn limit was tripped, 2 a --fail limit was tripped or nothing could be "
    "compared,\n"
    "3 sizes differ, 4 a file cannot be read, understood or written, 5 some cells failed, 64 wrong usage,\n"
    "70 internal or OpenGL failure, 130 interrupted.\n"
    "help COMMAND says more of a command.";

std::string command_line(int argc, char** argv) {
    std::string line = "aoscore";
    for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
    return line;
}

/// A standard stream that is closed would lend its number to the first file that is opened, and what is
/// printed would go into that. Writing to what stands in for it fails, as writing to a closed one does.
void hold_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != descriptor)
            throw internal_error("a standard stream is closed, and nothing can stand in for it");
    }
}

/// Prints what CLI11 has to say, which ends with a line break of its own.
void complain(std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    if (!text.empty()) log_error(text);
}

ExitCode run_program(int argc, char** argv) {
    hold_standard_streams();
    CLI::App program{
        "aoscore: how far screen-space ambient occlusion is from the ray-traced truth, where, and at what "
        "cost"};
    program.name("aoscore");
    program.set_version_flag("--version", std::string(version()));
    program.require_subcommand(1);
    program.fallthrough();
    program.footer(kFooter);

    GlobalOptions global;
    global.command_line = command_line(argc, argv);
    program.add_option("--seed", global.seed, "Of every random choice; the same seed gives the same images")
        ->capture_default_str();
    program
        .add_option("--threads", global.threads,
                    "Threads to use; 0 for all cores. Images do not depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    program.add_flag("--quiet", global.quiet, "Say nothing but errors and results");

    std::vector<CommandEntry> commands;
    for (const AddCommand add : kCommands) commands.push_back(add(program, global));
    const std::vector<std::string> words = arguments(argc, argv);
    if (words.empty()) {
        complain(program.help());
        return ExitCode::usage;
    }
    try {
        std::vector<std::string> last_first(words.rbegin(), words.rend());
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
    catch_interrupts();
    for (const CommandEntry& command : commands) {
        if (command.app->parsed()) return command.run();
    }
    throw internal_error("a subcommand was parsed that nobody runs");
}

}  // namespace
}  // namespace aoscore

int main(int argc, char** argv) {
    using aoscore::ExitCode;
    ExitCode code = ExitCode::internal;
    try {
        code = aoscore::run_program(argc, argv);
        aoscore::flush_output();
    } catch (const aoscore::Error& e) {
        aoscore::log_error(fmt::format("aoscore: {}", e.what()));
        code = e.exit_code();
    } catch (const std::bad_alloc&) {
        aoscore::log_error("aoscore: not enough memory");
    } catch (const std::filesystem::filesystem_error& e) {
        aoscore::log_error(fmt::format("aoscore: {}: {}", e.path1().string(), e.code().message()));
        code = ExitCode::file_error;
    } catch (const std::system_error& e) {
        const bool exhausted =
            e.code() == std::errc::resource_unavailable_try_again || e.code() == std::errc::not_enough_memory;
        aoscore::log_error(fmt::format(
            "aoscore: {}{}", exhausted ? "not enough memory or threads: " : "internal error: ", e.what()));
    } catch (const std::exception& e) {
        aoscore::log_error(fmt::format("aoscore: internal error: {}", e.what()));
    }
    return static_cast<int>(code);
}
