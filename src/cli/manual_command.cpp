#include "cli/command.h"
#include "cli/manual/completion.h"
#include "cli/manual/manual_page.h"
#include "core/files.h"
#include "core/known_names.h"
#include "core/output.h"

#include <memory>

namespace aoscore {
namespace {

struct ManualOptions {
    std::string command;
    std::filesystem::path into;
};

void print_manual(const ManualOptions& options, const CLI::App& program) {
    const std::vector<CommandRow> commands = command_table(program);
    if (!options.into.empty()) {
        for (const CommandRow& command : commands)
            write_atomically(options.into / manual_file(command),
                             manual_page(command, commands, program.get_footer()));
        return;
    }
    std::vector<std::string> names;
    for (const CommandRow& command : commands) {
        if (command.name == options.command) {
            write_output(manual_page(command, commands, program.get_footer()));
            return;
        }
        names.push_back(command.name);
    }
    throw unknown_name("no command", options.command, names);
}

}  // namespace

CommandEntry add_manual_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("manual", "Print a manual page, for man -l -");
    const auto options = std::make_shared<ManualOptions>();
    app->add_option("command", options->command, "The command that it is of [the program as a whole]");
    app->add_option("--into", options->into, "Write the pages of all commands into this folder");
    return {app, [options, &program] {
                print_manual(*options, program);
                return ExitCode::ok;
            }};
}

CommandEntry add_completion_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("completion", "Print a script that completes commands in a shell");
    const auto shell = std::make_shared<std::string>();
    app->add_option("shell", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kShells), std::end(kShells))));
    return {app, [shell, &program] {
                write_output(completion_script(*shell, command_table(program)));
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
