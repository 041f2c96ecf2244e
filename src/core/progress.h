#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace aoscore {

/// Progress of one piece of long work on standard error: a bar with an estimate of the time left on a
/// terminal; elsewhere a line at most every ten seconds. It shows nothing in quiet runs. Threads may call
/// step() freely.
class Progress {
  public:
    /// `what` as it is shown ("truth atrium/wide"), `total` in steps.
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step(std::size_t steps = 1);

  private:
    void draw(std::size_t done, double seconds, bool last);

    std::string what_;
    std::size_t total_;
    std::atomic<std::size_t> done_{0};
    std::chrono::steady_clock::time_point start_;
    std::atomic<double> next_draw_s_;
    std::mutex mutex_;
    bool terminal_;
    bool drawn_ = false;
};

}  // namespace aoscore
