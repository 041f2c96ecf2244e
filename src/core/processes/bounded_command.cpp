#include "core/processes/bounded_command.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/stopwatch.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

namespace aoscore {
namespace {

constexpr int kPoll_ms = 20;
constexpr double kGrace_s = 2;
constexpr std::size_t kMostKept = 4000;  // characters of what it printed

/// A group of processes, led by the one that was started; none of it outlives this object.
class ProcessGroup {
  public:
    ProcessGroup(const std::vector<std::string>& command, const std::filesystem::path& folder) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw internal_error(std::string("no pipe: ") + std::strerror(errno));
        output_ = ends[0];
        const int failure = spawn(command, folder, ends[1]);
        close(ends[1]);
        if (failure == 0) return;
        close(output_);
        throw file_error(std::string("cannot be started: ") + std::strerror(failure), command.front(),
                         "a program on the PATH, or a path");
    }
    ~ProcessGroup() {
        kill(-leader_, SIGKILL);
        if (!status_) waitpid(leader_, nullptr, 0);
        close(output_);
    }
    ProcessGroup(const ProcessGroup&) = delete;
    ProcessGroup& operator=(const ProcessGroup&) = delete;

    /// Waits a moment for output, which is kept, or the leader's end.
    bool has_ended(std::string& said) {
        pollfd ready{output_, POLLIN, 0};
        if (poll(&ready, 1, kPoll_ms) > 0) {
            std::array<char, 4096> text{};
            const ssize_t count = read(output_, text.data(), text.size());
            if (count > 0) said.append(text.data(), static_cast<std::size_t>(count));
            if (said.size() > kMostKept) said.erase(0, said.size() - kMostKept);
            if (count > 0) return false;
            poll(nullptr, 0, kPoll_ms);  // its output is closed: only its end is awaited
        }
        int status = 0;
        if (waitpid(leader_, &status, WNOHANG) == leader_) status_ = status;
        return status_.has_value();
    }
    void ask_to_end() const { kill(-leader_, SIGTERM); }
    int status() const { return *status_; }

  private:
    int spawn(const std::vector<std::string>& command, const std::filesystem::path& folder, int to_parent) {
        std::vector<std::string> texts = command;
        std::vector<char*> argv;
        for (std::string& text : texts) argv.push_back(text.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, to_parent, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, to_parent, STDERR_FILENO);
        posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        posix_spawnattr_setpgroup(&attributes, 0);
        const int failure = posix_spawnp(&leader_, argv.front(), &actions, &attributes, argv.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
        return failure;
    }

    pid_t leader_ = -1;
    int output_ = -1;
    std::optional<int> status_;
};

}  // namespace

CommandEnd run_bounded(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       double seconds) {
    if (command.empty()) throw internal_error("a command without a program");
    CommandEnd end;
    ProcessGroup group(command, folder);
    const Stopwatch watch;
    double patience_s = seconds;
    const auto ask = [&] {
        group.ask_to_end();
        patience_s = watch.seconds() + kGrace_s;
    };
    bool asked_by_interrupt = false;
    while (!group.has_ended(end.said)) {
        if (interrupt_requested() && !asked_by_interrupt) {
            asked_by_interrupt = true;
            ask();
        }
        if (watch.seconds() < patience_s) continue;
        if (end.timed_out || asked_by_interrupt) break;
        end.timed_out = true;
        ask();
    }
    throw_if_interrupted();
    if (end.timed_out) return end;
    const int status = group.status();
    if (WIFSIGNALED(status))
        end.signal = WTERMSIG(status);
    else
        end.exit_code = WEXITSTATUS(status);
    return end;
}

}  // namespace aoscore
