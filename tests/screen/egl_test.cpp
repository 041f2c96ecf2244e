// Pictures that EGL draws, beside those of OSMesa. Each has a process of its own, as the program has: a
// process holds one driver.
#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "hand_made.h"
#include "screen/gl/context.h"
#include "screen/gl/egl_context.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <span>

namespace aoscore::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// What a process that draws so writes: its driver's version, then a line for each picture.
std::string drawn_with(const char* gl, const fs::path& file) {
    const pid_t child = fork();
    if (child == 0) {
        setenv("AOSCORE_GL", gl, 1);
        setenv("AOSCORE_TEST_PICTURES", file.c_str(), 1);
        execl("/proc/self/exe", "test_screen", "--gtest_brief=1", "--gtest_also_run_disabled_tests",
              "--gtest_filter=EglChild.*", nullptr);
        _exit(127);
    }
    int status = -1;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return {};
    return read_file(file, 1 << 20);
}

// Both are llvmpipe here, of the same packages: the same bits. A machine with a GPU draws on its software
// device.
TEST(Egl, DrawsTheSamePicturesAsOsmesaWithTheSameDriver) {
    const fs::path folder = output_dir();
    const std::string osmesa = drawn_with("osmesa", folder / "osmesa.txt");
    const std::string egl = drawn_with("egl:software", folder / "egl.txt");
    ASSERT_FALSE(osmesa.empty());
    ASSERT_FALSE(egl.empty());
    EXPECT_EQ(egl, osmesa);
}

// This is no test, but the process that the test above starts.
TEST(EglChild, DISABLED_DrawsEveryMethod) {
    const Scene pillar = load_scene("pillar");
    ScreenRenderer renderer;
    renderer.set_scene(pillar);
    renderer.draw_gbuffer(CameraFrame(find_view(pillar, "main").camera, 160, 90), gbuffer_inputs());
    std::string lines = renderer.renderer() + " " + renderer.version() + "\n";
    const std::vector<MethodDescriptor> filters = load_filters();
    for (const MethodDescriptor& method : load_methods()) {
        const MethodRequest request = request_for(method, filters, "default");
        Digest digest;
        digest.array(std::span<const float>(renderer.run(request).visibility.pixels));
        lines += method.id + " " + digest.hex() + "\n";
    }
    write_atomically(std::getenv("AOSCORE_TEST_PICTURES"), lines);
}

TEST(Egl, DevicesThatAreNotThereAreRefusedWithThoseThatAre) {
    const std::vector<std::string> names = egl_devices();
    ASSERT_FALSE(names.empty());
    for (const std::string device : {"99", "no such device"}) {
        try {
            EglContext context(device);
            ADD_FAILURE() << device;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
            EXPECT_THAT(e.what(), HasSubstr(names.front()));
        }
    }
}

TEST(ChosenGl, NothingButOsmesaAndEglIsTaken) {
    for (const char* choice : {"", "glx", "egl:", "EGL"}) EXPECT_THROW(choose_gl(choice), Error) << choice;
    EXPECT_EQ(chosen_gl(), "osmesa");
}

}  // namespace
}  // namespace aoscore::testing
