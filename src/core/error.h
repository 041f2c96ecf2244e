#pragma once

#include <stdexcept>
#include <string>

namespace aoscore {

/// The exit codes of the program; documented in README.md and in `aoscore --help`.
enum class ExitCode : int {
    ok = 0,
    warned = 1,         ///< a --warn limit was tripped
    gate_failed = 2,    ///< a --fail limit was tripped
    sizes_differ = 3,   ///< images that should match differ in size or channels
    file_error = 4,     ///< an input cannot be read or understood, an output cannot be written
    cells_failed = 5,   ///< some scene x view x method cells of an experiment failed
    usage = 64,         ///< the command line is wrong, or names something unknown
    internal = 70,      ///< a defect of the program, or the graphics library failed
    interrupted = 130,  ///< Ctrl-C
};

/// The one exception type: what went wrong, where (file and place in it), and what would be valid.
class Error : public std::runtime_error {
  public:
    Error(ExitCode exit_code, std::string what, std::string where = {}, std::string valid = {});

    ExitCode exit_code() const { return exit_code_; }
    const std::string& where() const { return where_; }
    const std::string& valid() const { return valid_; }

  private:
    ExitCode exit_code_;
    std::string where_;
    std::string valid_;
};

/// An input or output file is at fault. `where` names the file and the place in it, such as
/// "room.gltf: accessors[3].count".
Error file_error(std::string what, std::string where, std::string valid = {});

/// The user asked for something that does not exist or does not make sense.
Error usage_error(std::string what, std::string where = {}, std::string valid = {});

/// A defect of this program or of a library under it.
Error internal_error(std::string what, std::string where = {});

/// Thrown where long work notices that Ctrl-C was pressed.
Error interrupted_error();

}  // namespace aoscore
