#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

inline constexpr char kProcessorMs[] = "processor ms";  ///< the unit

/// The cost of some work: seconds by the wall clock and of all processors, which other programs hardly touch.
struct Cost {
    double wall_s = std::numeric_limits<double>::infinity(), processor_s = wall_s;
    double peak_memory_mib = 0;  ///< of a process; 0 where it was not measured

    void keep_least(const Cost& other);
};

/// Of work done in this process, by all of its threads.
Cost cost_of(const std::function<void()>& work);

/// Of a program and the processes that it waits for; its output goes nowhere. Empty where it cannot be
/// started or ends with a code above `most_exit_code`.
std::optional<Cost> cost_of_program(const std::vector<std::string>& words, int most_exit_code = 0);

}  // namespace aoscore
