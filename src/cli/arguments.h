#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The words behind the program's name, prepared for the parser: `help score` becomes `score --help`,
/// and every assignment behind --set gets a --set of its own, so that the scene may follow them.
std::vector<std::string> arguments(int argc, char** argv);

/// The words without the -- with which some introduce the command that `plan` divides; any other -- stays.
std::vector<std::string> without_mark_of_command(const CLI::App& program, std::vector<std::string> words);

/// Says why words could not be parsed: names the first unknown command or option, and the one that was
/// probably meant; empty where all of them are known.
std::string unknown_word(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace aoscore
