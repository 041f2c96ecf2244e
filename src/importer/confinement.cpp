#include "importer/confinement.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>

namespace aoscore::importer {
namespace {

constexpr std::size_t kBaseMemory = std::size_t{2} << 30;
constexpr std::size_t kMemoryPerByte = 40;
constexpr std::size_t kBaseSeconds = 20, kSecondsPerFile = 2;
constexpr std::size_t kBytesPerSecond = std::size_t{1} << 20;

/// Whether a sanitizer is built in: it reserves terabytes of addresses.
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

/// Landlock (Linux 5.13, LANDLOCK_ACCESS_FS_*): only reading, and only below the folder. An older kernel goes
/// without: this is a second wall, the first is that nothing else is ever opened.
void see_only(const std::filesystem::path& folder) {
    landlock_ruleset_attr rules{};
    rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
    const auto set = static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0));
    if (set < 0) return;
    landlock_path_beneath_attr below{};
    below.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
    below.parent_fd = open(folder.c_str(), O_PATH | O_CLOEXEC | O_DIRECTORY);
    if (below.parent_fd >= 0) {
        syscall(SYS_landlock_add_rule, set, LANDLOCK_RULE_PATH_BENEATH, &below, 0);
        close(below.parent_fd);
    }
    syscall(SYS_landlock_restrict_self, set, 0);
    close(set);
}

}  // namespace

void confine(const std::filesystem::path& folder, std::size_t file_bytes) {
    std::signal(SIGINT, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    limit(RLIMIT_CORE, 0);
    if (!is_sanitized()) limit(RLIMIT_AS, kBaseMemory + kMemoryPerByte * file_bytes);
    see_only(folder);
    allow_time_for(file_bytes);
}

void allow_time_for(std::size_t bytes) {
    static std::size_t seconds = kBaseSeconds;
    seconds += kSecondsPerFile + bytes / kBytesPerSecond;
    limit(RLIMIT_CPU, seconds);
}

}  // namespace aoscore::importer
