#pragma once

#include "results/results.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// Median and half the distance between the quartiles of the runs; both empty without runs.
Timing summarize(std::vector<double> runs_ms);

/// When a thing has been timed often enough: as soon as the interval that holds its median with `confidence`
/// reaches no farther than `half_width` of the median to either side, after `least` and at the latest after
/// `most` runs.
struct TimingGoal {
    double confidence = 0.95;
    double half_width = 0.05;
    int least = 6;  ///< fewer have no interval of 95 % at all
    int most = 24;

    bool reached(const std::vector<double>& runs_ms) const;
};

/// How many runs a thing deserves, judged by how long its warm-up run took: at least 10, or 3 when one takes
/// over a second.
int timed_runs(double warm_up_ms);

/// Cells that are timed in turns where many are: a stopped run keeps the groups that are done, so that it
/// loses no more than one of them. The first group of a view has kFirstGroup.
inline constexpr std::size_t kFirstGroup = 4;
/// How many cells come after a group of `size` that took `seconds`: twice as many after a quick one, up to
/// 16, half as many after a slow one, down to 4.
std::size_t next_group(std::size_t size, double seconds);

}  // namespace aoscore
