#include "jobs/timing.h"

#include "metrics/intervals/median_interval.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

double quantile(const std::vector<double>& sorted, double q) {
    const double position = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(position));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

}  // namespace

Timing summarize(std::vector<double> runs_ms) {
    Timing timing;
    timing.runs_ms = runs_ms;
    if (runs_ms.empty()) return timing;
    std::sort(runs_ms.begin(), runs_ms.end());
    timing.median_ms = quantile(runs_ms, 0.5);
    timing.spread_ms = (quantile(runs_ms, 0.75) - quantile(runs_ms, 0.25)) / 2;
    return timing;
}

void PassRuns::add(const ScreenRenderer::PassTime& run) {
    ms.push_back(run.ms);
    if (run.processor_ms) processor_ms.push_back(*run.processor_ms);
}

Timing summarize(const PassRuns& runs) {
    Timing timing = summarize(runs.ms);
    timing.processor_runs_ms = runs.processor_ms;
    return timing;
}

bool TimingGoal::reached(const std::vector<double>& runs_ms) const {
    const int runs = static_cast<int>(runs_ms.size());
    if (runs >= most) return true;
    if (runs < least) return false;
    const auto interval = median_interval(runs_ms, confidence);
    if (!interval) return false;
    const double median = *summarize(runs_ms).median_ms;
    return interval->high - median <= half_width * median && median - interval->low <= half_width * median;
}

std::size_t next_group(std::size_t size, double seconds) {
    constexpr std::size_t kLargest = 16;
    constexpr double kQuick_s = 15, kSlow_s = 30;
    if (seconds < kQuick_s) return std::min(2 * size, kLargest);
    return seconds > kSlow_s ? std::max(size / 2, kFirstGroup) : size;
}

int timed_runs(double warm_up_ms) {
    return warm_up_ms > 1000 ? 3 : 10;
}

}  // namespace aoscore
