#include "importer/confinement.h"

#include "core/processes/process_limits.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace aoscore::importer {
namespace {

constexpr std::size_t kBaseMemory = std::size_t{2} << 30;
constexpr std::size_t kMemoryPerByte = 40;
constexpr std::size_t kBaseSeconds = 20, kSecondsPerFile = 2;
constexpr std::size_t kBytesPerSecond = std::size_t{1} << 20;

/// Allows only reading, and only below the folder, by Landlock (Linux 5.13, LANDLOCK_ACCESS_FS_*). It is the
/// second line of defence: nothing else is ever opened. An older kernel goes without it.
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
    follow_parent_process();
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    limit_memory(kBaseMemory + kMemoryPerByte * file_bytes);
    see_only(folder);
    allow_time_for(file_bytes);
}

void allow_time_for(std::size_t bytes) {
    static std::size_t seconds = kBaseSeconds;
    seconds += kSecondsPerFile + bytes / kBytesPerSecond;
    limit_processor_time(seconds);
}

}  // namespace aoscore::importer
