#include "bench/cost.h"

#include "core/stopwatch.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

namespace aoscore {
namespace {

/// The process, or -1.
pid_t started_silently(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    if (posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ) != 0) process = -1;
    posix_spawn_file_actions_destroy(&actions);
    return process;
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

void Cost::keep_least(const Cost& other) {
    wall_s = std::min(wall_s, other.wall_s);
    processor_s = std::min(processor_s, other.processor_s);
    peak_memory_mib = std::max(peak_memory_mib, other.peak_memory_mib);
}

Cost cost_of(const std::function<void()>& work) {
    const Stopwatch watch;
    const std::clock_t start = std::clock();
    work();
    return {watch.seconds(), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

std::optional<Cost> cost_of_program(const std::vector<std::string>& words, int most_exit_code) {
    const Stopwatch watch;
    const pid_t process = started_silently(words);
    if (process < 0) return std::nullopt;
    int status = 0;
    rusage used{};
    if (wait4(process, &status, 0, &used) != process) return std::nullopt;
    if (!WIFEXITED(status) || WEXITSTATUS(status) > most_exit_code) return std::nullopt;
    return Cost{watch.seconds(), seconds(used.ru_utime) + seconds(used.ru_stime),
                static_cast<double>(used.ru_maxrss) / 1024};
}

}  // namespace aoscore
