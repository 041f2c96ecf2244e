#include "core/processes/shell.h"

#include "core/printable.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

/// Quotes the argument as $'...', in which every byte can be written as an escape.
std::string ansi_quoted(const std::string& argument) {
    std::string result = "$'";
    for (const char c : argument) {
        const bool plain = c >= 0x20 && c < 0x7F && c != '\'' && c != '\\';
        result += plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
    return result + "'";
}

}  // namespace

std::string shell_quoted(const std::string& argument) {
    const bool plain =
        !argument.empty() && argument.find_first_not_of(
                                 "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                 "-_./,=:@%+") == std::string::npos;
    if (plain) return argument;
    if (printable(argument) != argument) return ansi_quoted(argument);
    std::string result = "'";
    for (const char c : argument) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace aoscore
