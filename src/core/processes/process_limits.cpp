#include "core/processes/process_limits.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>

namespace aoscore {
namespace {

constexpr bool is_sanitized() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return false;
#endif
}

void limit(__rlimit_resource resource, std::size_t value) {
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min<rlim_t>(value, limits.rlim_max);
    setrlimit(resource, &limits);
}

}  // namespace

void follow_parent_process() {
    std::signal(SIGINT, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
}

void limit_memory(std::size_t bytes) {
    if (!is_sanitized()) limit(RLIMIT_AS, bytes);
}

void limit_processor_time(std::size_t seconds) {
    limit(RLIMIT_CPU, seconds);
}

}  // namespace aoscore
