#include "core/log.h"

#include "core/printable.h"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <string>

namespace aoscore {
namespace {

bool g_quiet = false;
std::mutex g_mutex;

void write_line(std::string_view prefix, std::string_view line) {
    const std::scoped_lock lock(g_mutex);
    const std::string text = fmt::format("{}{}\n", prefix, printable_lines(line));
    std::fputs(text.c_str(), stderr);  // a log that cannot be written ends no run
}

}  // namespace

void set_quiet(bool quiet) {
    g_quiet = quiet;
}
bool quiet() {
    return g_quiet;
}
void log_info(std::string_view line) {
    if (!g_quiet) write_line("", line);
}
void log_warning(std::string_view line) {
    if (!g_quiet) write_line("warning: ", line);
}
void log_error(std::string_view line) {
    write_line("", line);
}

}  // namespace aoscore
