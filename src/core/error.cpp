#include "core/error.h"

#include "core/printable.h"

#include <utility>

namespace aoscore {
namespace {

std::string message(const std::string& what, const std::string& where, const std::string& valid) {
    std::string text;
    if (!where.empty()) text += printable(where) + ": ";
    text += printable_lines(what);  // a compiler's complaint shows lines of its source
    if (!valid.empty()) text += " (valid: " + printable(valid) + ")";
    return text;
}

}  // namespace

Error::Error(ExitCode exit_code, std::string what, std::string where, std::string valid)
    : std::runtime_error(message(what, where, valid)),
      exit_code_(exit_code),
      where_(std::move(where)),
      valid_(std::move(valid)) {}

Error file_error(std::string what, std::string where, std::string valid) {
    return Error(ExitCode::file_error, std::move(what), std::move(where), std::move(valid));
}

Error usage_error(std::string what, std::string where, std::string valid) {
    return Error(ExitCode::usage, std::move(what), std::move(where), std::move(valid));
}

Error internal_error(std::string what, std::string where) {
    return Error(ExitCode::internal, std::move(what), std::move(where));
}

Error interrupted_error() {
    return Error(ExitCode::interrupted, "interrupted");
}

}  // namespace aoscore
