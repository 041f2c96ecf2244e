#pragma once

#include <cstddef>
#include <functional>

namespace aoscore {

/// Limits all parallel work of the process to `count` threads; 0 means all cores. Results never depend on it.
void set_thread_count(int count);
int thread_count();
/// What set_thread_count() was told last; 0 where it was told nothing.
int chosen_thread_count();
/// The cores that this process may use.
int core_count();

/// Calls body(i) for every i in [0, count), in any order, on all threads. An exception of a body is rethrown.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace aoscore
