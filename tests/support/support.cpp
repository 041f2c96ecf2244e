#include "support/support.h"

#include "core/files.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace aoscore::testing {

namespace fs = std::filesystem;

fs::path output_dir() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    std::replace(name.begin(), name.end(), '/', '_');
    const fs::path folder = fs::path(AOSCORE_TEST_OUTPUT) / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

fs::path source_dir() {
    return AOSCORE_SOURCE_DIR;
}

std::string program() {
    return AOSCORE_PROGRAM;
}

fs::path shared_dir() {
    if (const char* dir = std::getenv("AOSCORE_SHARED"); dir != nullptr) return dir;
    const fs::path beside = source_dir().parent_path() / "shared";
    return fs::exists(beside) ? beside : fs::path();
}

ProgramRun run_aoscore(const std::string& arguments, const fs::path& folder, const std::string& prefix) {
    const fs::path out = folder / "stdout.txt", err = folder / "stderr.txt";
    // No test may use truths that another test, or the user, has traced.
    const std::string command = "cd '" + folder.string() + "' && export AOSCORE_CACHE='" +
                                (folder / "truth-cache").string() + "' && " + prefix + " '" + program() +
                                "' " + arguments + " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    ProgramRun run;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = read_file(out);
    run.err = read_file(err);
    return run;
}

ShellRun run_shell(const std::string& command) {
    ShellRun run;
    FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
    std::array<char, 4096> part;
    for (std::size_t n; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) run.text.append(part.data(), n);
    run.status = pclose(pipe);
    return run;
}

}  // namespace aoscore::testing
