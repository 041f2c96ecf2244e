// aoscore-shader-trial VERTEX FRAGMENT: compiles two files and draws with them, within limits of its own.
// Ends with 0 whether they compile or not; otherwise where memory or time does not suffice.
#include "core/files.h"
#include "core/threads.h"
#include "screen/draw_trial.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstddef>

namespace {

constexpr std::size_t kMostSeconds = 20;
constexpr std::size_t kMostMemory = std::size_t{2} << 30;

/// Whether a sanitizer is built in: it reserves terabytes of addresses.
constexpr bool is_sanitized() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return false;
#endif
}

void limit(__rlimit_resource resource, rlim_t value) {
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(value, limits.rlim_max);
    setrlimit(resource, &limits);
}

void limit_this_process() {
    std::signal(SIGINT, SIG_IGN);  // Ctrl-C is for the one who started this, and will end it
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, kMostSeconds);
    if (!is_sanitized()) limit(RLIMIT_AS, kMostMemory);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 64;
    limit_this_process();
    aoscore::set_thread_count(1);
    try {
        aoscore::draw_trial(aoscore::read_file(argv[1]), aoscore::read_file(argv[2]));
    } catch (...) {
        return 1;
    }
    return 0;
}
