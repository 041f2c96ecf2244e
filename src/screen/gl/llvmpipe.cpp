#include "screen/gl/llvmpipe.h"

#include "core/error.h"
#include "core/threads.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace aoscore {

void limit_rasteriser_threads() {
    setenv("LP_NUM_THREADS", std::to_string(thread_count()).c_str(), 0);
}

void require_addresses() {
    constexpr std::size_t kMiB = std::size_t{1} << 20, kThread = 72 * kMiB, kRest = 256 * kMiB;
    constexpr int kMostRasterisers = 32, kOwnThreads = 4;
    const int threads = std::min(thread_count(), kMostRasterisers) + kOwnThreads;
    const std::size_t needed = kRest + static_cast<std::size_t>(threads) * kThread;
    void* room = mmap(nullptr, needed, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        throw internal_error(
            fmt::format("not enough memory: {} MiB of addresses are needed for it, more than "
                        "the limit (ulimit -v) leaves; fewer --threads need less",
                        needed / kMiB),
            "OpenGL");
    munmap(room, needed);
}

}  // namespace aoscore
