#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <utility>

namespace aoscore {

/// These functions write results to standard output. All throw file_error where that fails, as on a full
/// disk.

/// Writes the text as printable_lines() shows it.
void write_output(std::string_view text);

template <class... Args>
void print_result(fmt::format_string<Args...> format, Args&&... args) {
    write_output(fmt::format(format, std::forward<Args>(args)...));
}

/// Writes a line with a file's path: through printable() on a terminal; elsewhere byte for byte, for scripts
/// that open it.
void print_path(const std::filesystem::path& path);

/// Writes what is buffered. Without this call a full disk may go unnoticed.
void flush_output();

}  // namespace aoscore
