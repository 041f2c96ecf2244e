#pragma once

#include "results/results.h"
#include "screen/screen.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// Median and half the distance between the quartiles of the runs; both empty without runs.
Timing summarize(std::vector<double> runs_ms);

/// The runs of one pass, in the order they were taken: by the clock, and as processor time of all threads.
struct PassRuns {
    std::vector<double> ms, processor_ms;

    bool empty() const { return ms.empty(); }
    void add(const ScreenRenderer::PassTime& run);
};
/// The same of both; empty without runs.
Timing summarize(const PassRuns& runs);

/// Says when a pass has been timed often enough: as soon as the interval that holds its median with
/// `confidence` extends no farther than `half_width` times the median to either side, after at least `least`
/// and at most `most` runs.
struct TimingGoal {
    double confidence = 0.95;
    double half_width = 0.05;
    int least = 6;  ///< fewer have no interval of 95 % at all
    int most = 24;

    bool reached(const std::vector<double>& runs_ms) const;
};

/// The number of runs for a pass by the time of its warm-up run: at least 10, or 3 when one takes over a
/// second.
int timed_runs(double warm_up_ms);

/// The number of cells in a view's first group where many are timed in turns: a stopped run keeps the groups
/// that are done, so that it loses no more than one.
inline constexpr std::size_t kFirstGroup = 4;
/// The size of the group after one of `size` cells that took `seconds`: twice as large after a quick one, up
/// to 16, half as large after a slow one, down to 4.
std::size_t next_group(std::size_t size, double seconds);

}  // namespace aoscore
