#pragma once

namespace aoscore {

/// Sets the number of threads of llvmpipe to thread_count(), where the environment does not. It reads it
/// once, when the first context is made.
void limit_rasteriser_threads();

/// Checks that enough addresses are left: Mesa does not check whether it got the memory that it asked for,
/// and crashes where it did not. It has the rasteriser's threads and a few of its own, each with a stack and
/// a heap of the C library. The numbers are those of Mesa 22.3, with room for the first shaders. Throws
/// internal_error.
void require_addresses();

}  // namespace aoscore
