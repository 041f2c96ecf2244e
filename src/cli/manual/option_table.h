#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// One option or positional argument of a command, as --help, the manual and the shells' completion show it.
struct OptionRow {
    std::vector<std::string> names;  ///< "--size", or that of a positional argument
    std::string value;               ///< what follows: "WxH"; empty for a switch
    std::vector<std::string> words;  ///< the values it takes, where they are few
    std::string text;
    bool positional = false;
    bool required = false;
    bool repeated = false;  ///< takes several values
};

struct CommandRow {
    std::string name;  ///< empty for the program itself
    std::string text;
    std::vector<OptionRow> options;
};

/// The program's own options, then its commands in the order of --help; read from what parses them, so that
/// nothing can be documented that is not there.
std::vector<CommandRow> command_table(const CLI::App& program);

}  // namespace aoscore
