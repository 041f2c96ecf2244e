#pragma once

#include <cstddef>

/// Limits that a child process sets for itself before it looks at anything that is not trusted.
namespace aoscore {

/// Ends this process when the one that started it ends, leaves Ctrl-C to that one, and writes no core file.
void follow_parent_process();

/// Limits the process to so many bytes of memory, beyond which allocations fail. It has no effect where
/// AddressSanitizer is built in, which reserves terabytes of addresses.
void limit_memory(std::size_t bytes);

/// Limits the process to so many seconds of processor time since it began; then SIGXCPU ends it.
void limit_processor_time(std::size_t seconds);

}  // namespace aoscore
