#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The words behind the program's name, as the parser is to see them: `help score` is `score --help`, and
/// every assignment behind --set gets a --set of its own, so that the scene may stand behind them.
std::vector<std::string> arguments(int argc, char** argv);

/// What is wrong with words that could not be parsed: the first unknown command or option, and which one was
/// meant; empty where all of them are known.
std::string unknown_word(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace aoscore
