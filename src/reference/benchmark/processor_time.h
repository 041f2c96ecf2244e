#pragma once

#include "core/processor_watch.h"
#include "core/threads.h"

namespace aoscore {

/// Processor time of all threads, divided among them: the time it takes on a machine that does nothing else.
template <class Work>
double seconds_of(const Work& work) {
    const ProcessorWatch watch;
    work();
    return watch.milliseconds() / 1000 / thread_count();
}

}  // namespace aoscore
