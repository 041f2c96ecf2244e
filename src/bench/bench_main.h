#pragma once

#include <cstdint>

namespace aoscore {

/// The main job, cold: every published table into a temporary folder, with truths of 64 rays a pixel that are
/// neither taken from the cache nor put there. Prints wall-clock seconds by stage,
/// peak memory, and how loading and G-buffer of the atrium compare with the whole, on standard output.
void bench_main(std::uint64_t seed);

}  // namespace aoscore
