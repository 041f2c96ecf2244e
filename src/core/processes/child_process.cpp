#include "core/processes/child_process.h"

#include "core/error.h"
#include "core/interrupt.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace aoscore {
namespace {

/// A pipe's two ends: the one to read from, then the one to write to.
std::pair<int, int> make_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw internal_error(std::string("no pipe: ") + std::strerror(errno));
    return {ends[0], ends[1]};
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    const auto [from_child, to_parent] = make_pipe();
    output_ = from_child;
    std::string name = program.string();
    std::vector<std::string> texts = arguments;
    std::vector<char*> argv{name.data()};
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, to_parent, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    const int failure = posix_spawn(&pid_, name.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(to_parent);
    if (failure == 0) return;
    close(output_);
    throw internal_error(std::string("cannot be started: ") + std::strerror(failure), name);
}

ChildProcess::~ChildProcess() {
    close(output_);
    if (pid_ < 0) return;
    kill(pid_, SIGKILL);
    wait();
}

std::size_t ChildProcess::read(void* to, std::size_t size) {
    constexpr int kPatience_ms = 50;
    for (;;) {
        throw_if_interrupted();
        pollfd ready{output_, POLLIN, 0};
        if (poll(&ready, 1, kPatience_ms) <= 0) continue;
        const ssize_t count = ::read(output_, to, size);
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno != EINTR) throw internal_error(std::string("a pipe broke: ") + std::strerror(errno));
    }
}

ChildProcess::End ChildProcess::wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}

}  // namespace aoscore
