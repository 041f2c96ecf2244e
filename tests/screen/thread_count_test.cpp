// Compares depth layers that are drawn by other numbers of threads, bit by bit.
#include "core/files.h"
#include "core/hash.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <span>

namespace aoscore::testing {
namespace {

namespace fs = std::filesystem;

/// The threads of this process that draw for llvmpipe.
int rasteriser_threads() {
    int count = 0;
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::string name;
        std::ifstream(task.path() / "comm") >> name;
        count += name.starts_with("llvmpipe") ? 1 : 0;
    }
    return count;
}

/// What a process with so many rasteriser threads writes: a line for each drawing. llvmpipe reads their
/// number once, so that each needs a process.
std::string drawn_by(int threads, const fs::path& file) {
    const pid_t child = fork();
    if (child == 0) {
        setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
        setenv("AOSCORE_TEST_LAYERS", file.c_str(), 1);
        execl("/proc/self/exe", "test_screen", "--gtest_brief=1", "--gtest_also_run_disabled_tests",
              "--gtest_filter=ThreadCountChild.*", nullptr);
        _exit(127);
    }
    int status = -1;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return {};
    return read_file(file, 1 << 20);
}

TEST(DepthLayers, DoNotDependOnTheNumberOfThreads) {
    const fs::path folder = output_dir();
    const std::string one = drawn_by(1, folder / "1.txt");
    ASSERT_FALSE(one.empty());
    for (const int threads : {2, 3})
        EXPECT_EQ(drawn_by(threads, folder / (std::to_string(threads) + ".txt")), one) << threads;
}

// This is no test, but the process that the test above starts.
TEST(ThreadCountChild, DISABLED_DrawsDepthLayers) {
    const Scene atrium = load_scene("atrium");
    ScreenRenderer renderer;
    renderer.set_scene(atrium);
    renderer.draw_gbuffer(CameraFrame(find_view(atrium, "wide").camera, 320, 180), {});
    std::string lines;
    for (const DepthSampling& sampling : depth_samplings()) {
        if (!is_rasterised(sampling.id)) continue;
        renderer.draw_depth_layers({.samples = 8, .alpha = 0.2, .sampling = std::string(sampling.id)});
        Digest digest;
        for (const ImageF& sample : renderer.read_depth_layers())
            digest.array(std::span<const float>(sample.pixels));
        lines += std::string(sampling.id) + " " + digest.hex() + "\n";
    }
    ASSERT_EQ(std::to_string(rasteriser_threads()), std::getenv("LP_NUM_THREADS"));
    write_atomically(std::getenv("AOSCORE_TEST_LAYERS"), lines);
}

}  // namespace
}  // namespace aoscore::testing
