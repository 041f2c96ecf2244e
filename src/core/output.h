#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <utility>

namespace aoscore {

/// Results on standard output. All throw file_error where it cannot be written, as on a full disk.

/// As printable_lines() shows it.
void write_output(std::string_view text);

template <class... Args>
void print_result(fmt::format_string<Args...> format, Args&&... args) {
    write_output(fmt::format(format, std::forward<Args>(args)...));
}

/// A line with a file's path: on a terminal fit to be shown, elsewhere byte for byte, for scripts that open
/// it.
void print_path(const std::filesystem::path& path);

/// What is buffered is written. Without it a full disk may go unnoticed.
void flush_output();

}  // namespace aoscore
