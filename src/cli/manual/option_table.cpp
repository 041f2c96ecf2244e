#include "cli/manual/option_table.h"

#include <sstream>

namespace aoscore {
namespace {

/// The words of "TEXT:{far,clamp}"; none where there are no braces.
std::vector<std::string> words_in_braces(const std::string& value) {
    const std::size_t open = value.find('{'), close = value.find('}', open);
    if (open == std::string::npos || close == std::string::npos) return {};
    std::istringstream list(value.substr(open + 1, close - open - 1));
    std::vector<std::string> words;
    for (std::string word; std::getline(list, word, ',');) words.push_back(word);
    return words;
}

OptionRow described(const CLI::Option& option) {
    OptionRow row;
    row.positional = option.get_positional();
    if (row.positional) {
        row.names = {option.get_name(true)};
    } else {
        for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
        for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
    }
    if (option.get_items_expected_max() > 0) row.value = option.get_type_name();
    row.words = words_in_braces(row.value);
    row.text = option.get_description();
    if (const std::string& value = option.get_default_str(); !value.empty()) row.text += " [" + value + "]";
    row.required = option.get_required();
    row.repeated = option.get_items_expected_max() > 1;
    return row;
}

CommandRow described(const CLI::App& app) {
    CommandRow row{app.get_name(), app.get_description(), {}};
    for (const CLI::Option* option : app.get_options()) row.options.push_back(described(*option));
    return row;
}

}  // namespace

std::vector<CommandRow> command_table(const CLI::App& program) {
    std::vector<CommandRow> table{described(program)};
    table.front().name.clear();
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        table.push_back(described(*command));
    return table;
}

}  // namespace aoscore
