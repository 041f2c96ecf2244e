#include "core/interrupt.h"

#include "core/error.h"
#include "core/log.h"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <thread>

namespace aoscore {
namespace {

// The time of the first signal; 0 before it. Any thread may be given a signal.
std::atomic<std::int64_t> g_first_ns = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a handler must not wait for a lock");

std::int64_t now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

// One press of Ctrl-C may come twice: `timeout` signals the process and then its group, a build tool passes
// on what the terminal has sent already.
constexpr std::int64_t kSameRequest_ns = 1'000'000'000;

sem_t g_came;

void on_signal(int signal_number) {
    const std::int64_t now = now_ns();
    std::int64_t first = 0;
    if (g_first_ns.compare_exchange_strong(first, now)) {
        sem_post(&g_came);
        return;
    }
    if (now - first <= kSameRequest_ns) return;
    std::signal(signal_number, SIG_DFL);
    raise(signal_number);
}

// Work that asks for nothing while it is under way, such as a compiler's, must not hold up the end.
constexpr std::chrono::seconds kPatience{10};

void end_what_goes_on() {
    while (sem_wait(&g_came) != 0) {
    }
    std::this_thread::sleep_for(kPatience);
    log_error("aoscore: interrupted; what was under way has not ended by itself");
    _exit(static_cast<int>(ExitCode::interrupted));
}

}  // namespace

void catch_interrupts() {
    sem_init(&g_came, 0, 0);
    std::thread(end_what_goes_on).detach();
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupt_requested() {
    return g_first_ns != 0;
}

void throw_if_interrupted() {
    if (interrupt_requested()) throw interrupted_error();
}

}  // namespace aoscore
