#include "cli/arguments.h"

#include "core/known_names.h"

#include <algorithm>

namespace aoscore {
namespace {

bool is_assignment(const std::string& word) {
    return !word.starts_with('-') && word.find('=') != std::string::npos;
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

const CLI::Option* find_option(const CLI::App& program, const CLI::App* command, const std::string& name) {
    const CLI::Option* option = command == nullptr ? nullptr : command->get_option_no_throw(name);
    return option != nullptr ? option : program.get_option_no_throw(name);
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

const CLI::App* find_command(const CLI::App& program, const std::string& name) {
    for (const CLI::App* command : commands_of(program)) {
        if (command->get_name() == name) return command;
    }
    return nullptr;
}

std::string unknown_command(const CLI::App& program, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands_of(program)) names.push_back(command->get_name());
    return unknown_name("no command", word, names).what();
}

std::string unknown_option(const CLI::App& program, const CLI::App* command, const std::string& name) {
    std::vector<std::string> names = option_names(program);
    if (command != nullptr) {
        const std::vector<std::string> own = option_names(*command);
        names.insert(names.begin(), own.begin(), own.end());
    }
    return unknown_name_text(command == nullptr ? "no option" : command->get_name() + " has no option", name,
                             names);
}

/// The place of the first word from `at` on that is neither an option nor an option's value.
std::size_t first_operand(const CLI::App& program, const CLI::App* command,
                          const std::vector<std::string>& words, std::size_t at) {
    for (; at < words.size() && words[at].starts_with('-') && words[at] != "--"; ++at) {
        const std::string name = words[at].substr(0, words[at].find('='));
        const CLI::Option* option = find_option(program, command, name);
        const bool takes_next = option != nullptr && option->get_items_expected_max() > 0;
        if (takes_next && name == words[at]) ++at;
    }
    return at;
}

}  // namespace

std::vector<std::string> arguments(int argc, char** argv) {
    std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        if (words.size() > 1) words.resize(1);
        words.emplace_back("--help");
    }
    std::vector<std::string> result;
    bool setting = false;
    for (const std::string& word : words) {
        const bool another = setting && is_assignment(word) && result.back() != "--set";
        if (another) result.emplace_back("--set");
        setting = word == "--set" || (setting && is_assignment(word));
        result.push_back(word);
    }
    return result;
}

std::vector<std::string> without_mark_of_command(const CLI::App& program, std::vector<std::string> words) {
    const std::size_t command = first_operand(program, nullptr, words, 0);
    if (command >= words.size() || words[command] != "plan") return words;
    const std::size_t mark = first_operand(program, find_command(program, "plan"), words, command + 1);
    if (mark < words.size() && words[mark] == "--")
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(mark));
    return words;
}

std::string unknown_word(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App* command = nullptr;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (!word.starts_with("--")) {
            if (command != nullptr) continue;
            command = find_command(program, word);
            if (command == nullptr) return unknown_command(program, word);
            continue;
        }
        const std::string name = word.substr(0, word.find('='));
        if (name == "--help") continue;
        const CLI::Option* option = find_option(program, command, name);
        if (option == nullptr) return unknown_option(program, command, name);
        // The word behind it is its value, not a command.
        if (command == nullptr && option->get_items_expected_max() > 0 && name == word) ++i;
    }
    return {};
}

}  // namespace aoscore
