#include "cli/manual/completion.h"

#include "core/processes/shell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace aoscore {
namespace {

/// Values that the program lists.
struct Listed {
    std::string_view option;
    std::string_view subject;  ///< of aoscore list
};
constexpr std::array kListed = {Listed{"--methods", "methods"}, Listed{"--filter", "methods"},
                                Listed{"scene", "scenes"}, Listed{"scenes", "scenes"}};

std::string_view listed_subject(const OptionRow& option) {
    for (const Listed& listed : kListed) {
        if (std::ranges::find(option.names, listed.option) != option.names.end()) return listed.subject;
    }
    return {};
}

/// A command of the shell that prints the values of an option, a line each; empty where any file will do.
std::string value_command(const OptionRow& option) {
    if (!option.words.empty()) {
        std::string command = "printf '%s\\n'";
        for (const std::string& word : option.words) command += " " + shell_quoted(word);
        return command;
    }
    const std::string_view subject = listed_subject(option);
    return subject.empty() ? "" : fmt::format("aoscore list {} 2>/dev/null | cut -d' ' -f1", subject);
}

std::vector<std::string> option_names(const CommandRow& command) {
    std::vector<std::string> names;
    for (const OptionRow& option : command.options) {
        if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

std::vector<std::string> command_names(const std::vector<CommandRow>& commands) {
    std::vector<std::string> names;
    for (const CommandRow& command : commands) {
        if (!command.name.empty()) names.push_back(command.name);
    }
    return names;
}

/// The cases of a bash function that knows the command and the word before the one to complete.
std::string bash_cases(const std::vector<CommandRow>& commands) {
    std::string cases;
    for (const CommandRow& command : commands) {
        for (const OptionRow& option : command.options) {
            const std::string values = value_command(option);
            if (values.empty() && option.value.empty()) continue;
            const std::string action = values.empty() ? "compopt -o default" : "words=$(" + values + ")";
            const std::string of = command.name.empty() ? "*" : command.name;
            if (option.positional) {
                cases += fmt::format("        '{} ') [[ $cur == -* ]] || {{ {}; compopt -o default; }} ;;\n",
                                     of, action);
                continue;
            }
            for (const std::string& name : option.names)
                cases += fmt::format("        {}' {}') {}; return_values=1 ;;\n",
                                     of == "*" ? of : "'" + of + "'", name, action);
        }
    }
    return cases;
}

std::string bash_script(const std::vector<CommandRow>& commands) {
    std::string options;
    for (const CommandRow& command : commands)
        options += fmt::format("        '{}') options='{}' ;;\n", command.name,
                               fmt::join(option_names(command), " "));
    return fmt::format(
        R"(# Completion of aoscore for bash: source it, or put it where bash-completion looks for it.
_aoscore() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command='' options='' words='' return_values='' i
    local commands='{} help'
    for ((i = 1; i < COMP_CWORD; i++)); do
        [[ " $commands " == *" ${{COMP_WORDS[i]}} "* ]] && {{ command=${{COMP_WORDS[i]}}; break; }}
    done
    [[ $before == -* ]] || before=''
    case "$command $before" in
{}    esac
    if [[ -z $return_values ]]; then
        case "$command" in
{}        esac
        if [[ $cur == -* ]]; then words=$options
        elif [[ -z $command || $command == help ]]; then words=$commands
        fi
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
}}
complete -F _aoscore aoscore
)",
        fmt::join(command_names(commands), " "), bash_cases(commands), options);
}

/// Text in a specification of zsh's _arguments, within single quotes.
std::string zsh_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\'')
            escaped += "'\\''";
        else if (c == '[' || c == ']' || c == ':' || c == '\\')
            escaped += std::string("\\") + c;
        else
            escaped += c;
    }
    return escaped;
}

std::string zsh_action(const OptionRow& option) {
    const std::string values = value_command(option);
    if (values.empty()) return "_files";
    std::string quoted;
    for (const char c : values) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return "{compadd -- ${(f)\"$(" + quoted + ")\"}}";
}

std::string zsh_specs(const CommandRow& command) {
    std::string specs;
    for (const OptionRow& option : command.options) {
        if (option.positional) {
            specs += fmt::format(" \\\n            '{}:{}:{}'", option.repeated ? "*" : "",
                                 option.names.front(), zsh_action(option));
            continue;
        }
        for (const std::string& name : option.names) {
            specs += fmt::format(" \\\n            '*{}[{}]", name, zsh_text(option.text));
            specs += option.value.empty() ? "'" : fmt::format(":value:{}'", zsh_action(option));
        }
    }
    return specs;
}

std::string zsh_script(const std::vector<CommandRow>& commands) {
    std::string names, cases;
    for (const CommandRow& command : commands) {
        if (command.name.empty()) continue;
        names += fmt::format("        '{}:{}'\n", command.name, zsh_text(command.text));
        cases += fmt::format("        {})\n        _arguments{} ;;\n", command.name, zsh_specs(command));
    }
    return fmt::format(R"(#compdef aoscore
# Completion of aoscore for zsh: put it into a folder of $fpath as _aoscore.
_aoscore() {{
    local -a commands
    commands=(
{}    )
    if (( CURRENT == 2 )); then
        _describe command commands
        return
    fi
    local command=$words[2]
    shift words
    (( CURRENT-- ))
    case $command in
{}    esac
}}
_aoscore "$@"
)",
                       names, cases);
}

std::string fish_script(const std::vector<CommandRow>& commands) {
    std::string script =
        "# Completion of aoscore for fish: put it into ~/.config/fish/completions/aoscore.fish.\n";
    for (const CommandRow& command : commands) {
        std::string when;
        if (!command.name.empty()) {
            script += fmt::format("complete -c aoscore -n __fish_use_subcommand -f -a {} -d {}\n",
                                  command.name, shell_quoted(command.text));
            when = fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name);
        }
        for (const OptionRow& option : command.options) {
            const std::string values = value_command(option);
            std::string line = "complete -c aoscore" + when;
            for (const std::string& name : option.names) {
                if (option.positional) continue;
                line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            }
            if (!option.positional && !option.value.empty()) line += " -r";
            if (!values.empty()) line += " -a " + shell_quoted("(" + values + ")");
            if (option.positional && values.empty()) continue;
            script +=
                line + " -d " + shell_quoted(option.positional ? option.names.front() : option.text) + "\n";
        }
    }
    return script;
}

}  // namespace

std::string completion_script(std::string_view shell, const std::vector<CommandRow>& commands) {
    if (shell == "bash") return bash_script(commands);
    return shell == "zsh" ? zsh_script(commands) : fish_script(commands);
}

}  // namespace aoscore
