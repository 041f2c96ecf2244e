#include "store/truth/entry_lock.h"

#include "core/error.h"
#include "core/interrupt.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace aoscore {
namespace {

constexpr std::chrono::milliseconds kPoll{50};

/// Whether the path still names the open file, which its last owner may have removed meanwhile.
bool is_file(int descriptor, const std::filesystem::path& path) {
    struct stat mine {};
    struct stat named {};
    return fstat(descriptor, &mine) == 0 && stat(path.c_str(), &named) == 0 && mine.st_ino == named.st_ino &&
           mine.st_dev == named.st_dev;
}

}  // namespace

EntryLock::EntryLock(std::filesystem::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

EntryLock::EntryLock(EntryLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

EntryLock::~EntryLock() {
    if (descriptor_ < 0) return;
    unlink(path_.c_str());
    close(descriptor_);
}

std::optional<EntryLock> EntryLock::try_acquire(const std::filesystem::path& path) {
    while (true) {
        const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (descriptor < 0) throw file_error(std::strerror(errno), path.string());
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int why = errno;
            // Some network file systems have no locks: two processes may then do the same work, with the same result.
            if (why == ENOLCK || why == EOPNOTSUPP) return EntryLock(path, descriptor);
            close(descriptor);
            if (why == EWOULDBLOCK || why == EINTR) return std::nullopt;
            throw file_error(std::string("cannot be locked: ") + std::strerror(why), path.string());
        }
        if (is_file(descriptor, path)) return EntryLock(path, descriptor);
        close(descriptor);
    }
}

EntryLock EntryLock::acquire(const std::filesystem::path& path, const std::function<void()>& waiting) {
    bool said = false;
    while (true) {
        if (std::optional<EntryLock> lock = try_acquire(path)) return std::move(*lock);
        if (!std::exchange(said, true)) waiting();
        throw_if_interrupted();
        std::this_thread::sleep_for(kPoll);
    }
}

}  // namespace aoscore
