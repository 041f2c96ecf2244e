#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace aoscore::testing {

/// A new, empty folder for the running test alone, which stays for inspection.
std::filesystem::path output_dir();

/// The folder of shared inputs (../shared from the project's root, or AOSCORE_SHARED); empty when it is not
/// there.
std::filesystem::path shared_dir();

/// The source tree that these tests were built from.
std::filesystem::path source_dir();

/// The path of the built `aoscore`.
std::string program();

struct ProgramRun {
    int exit_code = 0;
    std::string out;
    std::string err;
};
/// Runs the built `aoscore` with these arguments, in `folder`, with a truth cache of its own there. `prefix`
/// is put before it: "timeout 5".
ProgramRun run_aoscore(const std::string& arguments, const std::filesystem::path& folder,
                       const std::string& prefix = {});

/// How a shell's command ended, and what it printed on both streams.
struct ShellRun {
    int status = -1;  ///< as waitpid() states it: 0 where it ended well
    std::string text;
};
ShellRun run_shell(const std::string& command);

}  // namespace aoscore::testing

/// Skips the test where the shared inputs are absent; fails it there when CI=true.
#define REQUIRE_SHARED_INPUTS()                                                                  \
    if (aoscore::testing::shared_dir().empty()) {                                                \
        const char* ci = std::getenv("CI");                                                      \
        if (ci != nullptr && std::string(ci) == "true") FAIL() << "shared inputs are not there"; \
        GTEST_SKIP() << "shared inputs are not there (set AOSCORE_SHARED)";                      \
    }                                                                                            \
    static_assert(true)
