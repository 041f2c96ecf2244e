#include "core/progress.h"

#include "core/log.h"
#include "core/printable.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace aoscore {
namespace {

constexpr double kTerminalInterval_s = 0.1;
constexpr double kLogInterval_s = 10.0;
constexpr int kBarWidth = 30;

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(std::max<std::size_t>(total, 1)),
      start_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO) != 0) {
    next_draw_s_ = terminal_ ? kTerminalInterval_s : kLogInterval_s;
}

Progress::~Progress() {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (drawn_) draw(done_, elapsed.count(), true);
}

void Progress::step(std::size_t steps) {
    const std::size_t done = done_ += steps;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (quiet() || elapsed.count() < next_draw_s_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || elapsed.count() < next_draw_s_) return;
    next_draw_s_ = elapsed.count() + (terminal_ ? kTerminalInterval_s : kLogInterval_s);
    draw(done, elapsed.count(), false);
    drawn_ = true;
}

void Progress::draw(std::size_t done, double seconds, bool last) {
    const double fraction = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
    const double left_s = fraction > 0 ? seconds * (1 - fraction) / fraction : 0;
    const std::string times = last ? fmt::format("{:.1f} s", seconds)
                                   : fmt::format("{:.0f} s, about {:.0f} s left", seconds, left_s);
    if (!terminal_) {
        log_info(fmt::format("{}: {:.0f} %, {}", what_, 100 * fraction, times));
        return;
    }
    const int filled = static_cast<int>(fraction * kBarWidth);
    const std::string line =
        fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {:.0f} %, {}{}", printable(what_), "", filled, "",
                    kBarWidth - filled, 100 * fraction, times, last ? "\n" : "");
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace aoscore
