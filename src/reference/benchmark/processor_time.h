#pragma once

#include "core/threads.h"

#include <ctime>

namespace aoscore {

/// Processor time of all threads, divided among them: the time it takes on a machine that does nothing else.
template <class Work>
double seconds_of(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / thread_count();
}

}  // namespace aoscore
