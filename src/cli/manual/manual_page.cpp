#include "cli/manual/manual_page.h"

#include "core/files.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

/// Text as roff prints it: no line begins with a control character, and a hyphen is one that can be copied.
std::string roff(const std::string& text) {
    std::string escaped;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else
            escaped += c;
        line_begins = c == '\n';
    }
    return escaped;
}

/// The program's text begins with its name, which the page's head names itself.
std::string without_name(const std::string& text) {
    constexpr std::string_view kName = "aoscore: ";
    return text.starts_with(kName) ? text.substr(kName.size()) : text;
}

std::string synopsis(const CommandRow& command) {
    std::string line = ".B aoscore" + (command.name.empty() ? "" : " " + roff(command.name)) + "\n";
    line += command.name.empty() ? ".I command\n[option...]\n" : "[option...]\n";
    for (const OptionRow& option : command.options) {
        if (!option.positional) continue;
        const std::string name = roff(option.names.front()) + (option.repeated ? "..." : "");
        line += option.required ? ".I " + name + "\n" : fmt::format("[\\fI{}\\fR]\n", name);
    }
    return line;
}

std::string option_entry(const OptionRow& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    if (!option.value.empty())
        names += " \\fI" + roff(option.value) + (option.repeated ? "\\fR ..." : "\\fR");
    return ".TP\n" + names + "\n" + roff(option.text) + "\n";
}

}  // namespace

std::string manual_file(const CommandRow& command) {
    return command.name.empty() ? "aoscore.1" : "aoscore-" + command.name + ".1";
}

std::string manual_page(const CommandRow& command, const std::vector<CommandRow>& all,
                        const std::string& end) {
    const bool program = command.name.empty();
    const std::string title = program ? "aoscore" : "aoscore-" + command.name;
    std::string page =
        fmt::format(".TH \"{}\" 1 \"\" \"aoscore {}\" \"User Commands\"\n", roff(title), version());
    page += fmt::format(".SH NAME\n{} \\- {}\n", roff(title), roff(without_name(command.text)));
    page += ".SH SYNOPSIS\n" + synopsis(command);
    if (program) {
        page += ".SH COMMANDS\nEach has a manual page of its own.\n";
        for (const CommandRow& other : all) {
            if (!other.name.empty())
                page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(other.name), roff(other.text));
        }
    }
    page += ".SH OPTIONS\n";
    for (const OptionRow& option : command.options) page += option_entry(option);
    page += ".SH EXIT STATUS\n" + roff(end) + "\n";
    page += program ? ".SH SEE ALSO\n\\fBaoscore\\-run\\fR(1)\n" : ".SH SEE ALSO\n\\fBaoscore\\fR(1)\n";
    return page;
}

}  // namespace aoscore
