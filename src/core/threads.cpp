#include "core/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

namespace aoscore {
namespace {

int g_thread_count = 0;
std::unique_ptr<tbb::global_control> g_limit;

}  // namespace

void set_thread_count(int count) {
    g_thread_count = count;
    g_limit = count > 0 ? std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                                static_cast<std::size_t>(count))
                        : nullptr;
}

int thread_count() {
    return g_thread_count > 0 ? g_thread_count : core_count();
}

int chosen_thread_count() {
    return g_thread_count;
}

int core_count() {
    return std::max(1, tbb::info::default_concurrency());
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { body(i); });
}

}  // namespace aoscore
