#include "core/log.h"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>

namespace aoscore {
namespace {

bool g_quiet = false;
std::mutex g_mutex;

void write_line(std::string_view prefix, std::string_view line) {
    if (g_quiet) return;
    const std::scoped_lock lock(g_mutex);
    fmt::print(stderr, "{}{}\n", prefix, line);
}

}  // namespace

void set_quiet(bool quiet) {
    g_quiet = quiet;
}
bool quiet() {
    return g_quiet;
}
void log_info(std::string_view line) {
    write_line("", line);
}
void log_warning(std::string_view line) {
    write_line("warning: ", line);
}

}  // namespace aoscore
