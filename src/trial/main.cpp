// aoscore-shader-trial VERTEX FRAGMENT: compiles two files and draws with them, within limits of its own.
// Ends with 0 whether they compile or not, and otherwise where memory or time does not suffice.
#include "core/files.h"
#include "core/processes/process_limits.h"
#include "core/threads.h"
#include "screen/trial/draw_trial.h"

#include <cstddef>

namespace {

constexpr std::size_t kMostSeconds = 20;
constexpr std::size_t kMostMemory = std::size_t{2} << 30;

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 64;
    aoscore::follow_parent_process();
    aoscore::limit_processor_time(kMostSeconds);
    aoscore::limit_memory(kMostMemory);
    aoscore::set_thread_count(1);
    try {
        aoscore::draw_trial(aoscore::read_file(argv[1]), aoscore::read_file(argv[2]));
    } catch (...) {
        return 1;
    }
    return 0;
}
