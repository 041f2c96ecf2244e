#include "core/node_kind.h"

#include "core/counted.h"
#include "core/error.h"
#include "core/machine.h"
#include "core/threads.h"

#include <fmt/format.h>

#include <cstdlib>

namespace aoscore {
namespace {

std::string g_kind;

std::string kind_by_processor() {
    return fmt::format("{}, {} threads", cpu_name(), core_count());
}

}  // namespace

std::string own_node_kind() {
    const char* named = std::getenv("AOSCORE_NODE_KIND");
    return named != nullptr && *named != '\0' ? named : kind_by_processor();
}

void choose_node_kind(const std::string& kind) {
    g_kind = kind;
}

std::string node_kind() {
    return g_kind.empty() ? own_node_kind() : g_kind;
}

bool takes_times() {
    return node_kind() == own_node_kind();
}

void require_times_here(const std::string& what) {
    if (takes_times()) return;
    throw usage_error(fmt::format("{} takes times, and this machine is a node of kind \"{}\", not of \"{}\"",
                                  what, own_node_kind(), node_kind()),
                      "--node-kind", "a machine of that kind, or no --node-kind");
}

std::string times_elsewhere_text() {
    return fmt::format("times are taken on nodes of kind \"{}\", and this is one of kind \"{}\"", node_kind(),
                       own_node_kind());
}

std::string times_left_out_text(std::size_t count) {
    return fmt::format("{}: {}", counted(count, "time is left out", "times are left out"),
                       times_elsewhere_text());
}

// With another number of threads a node is as fast as another kind.
std::string timed_on() {
    const int threads = chosen_thread_count();
    return threads == 0 ? node_kind() : fmt::format("{}; --threads {}", node_kind(), threads);
}

std::string machine_name() {
    if (!takes_times()) return fmt::format("{} (times: nodes of kind \"{}\")", cpu_name(), node_kind());
    if (node_kind() == kind_by_processor()) return cpu_name();
    return fmt::format("{} (a node of kind \"{}\")", cpu_name(), node_kind());
}

}  // namespace aoscore
