#include "core/interrupt.h"

#include "core/error.h"

#include <csignal>

namespace aoscore {
namespace {

volatile std::sig_atomic_t g_requested = 0;

void on_signal(int signal_number) {
    g_requested = 1;
    std::signal(signal_number, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

bool interrupt_requested() {
    return g_requested != 0;
}

void throw_if_interrupted() {
    if (interrupt_requested()) throw interrupted_error();
}

}  // namespace aoscore
