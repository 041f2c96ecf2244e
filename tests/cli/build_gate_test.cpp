// Tests a gate in a user's build: README's CTest project, word for word.
#include "core/files.h"
#include "core/folders.h"
#include "core/processes/shell.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

/// The only block of CMake in README.md.
std::string readme_project() {
    const std::string readme = read_file(data_dir() / "README.md"), fence = "```cmake\n";
    const auto begin = readme.find(fence);
    EXPECT_NE(begin, std::string::npos);
    const auto end = readme.find("```", begin + fence.size());
    return readme.substr(begin + fence.size(), end - begin - fence.size());
}

/// A user's project in a folder of the test.
class Project {
  public:
    explicit Project(const std::filesystem::path& folder) : folder_(folder) {}

    /// Whether the tests of the build pass; log() has its output.
    bool passes(const std::string& lists) {
        write_atomically(folder_ / "CMakeLists.txt", lists);
        const std::string command =
            "cd " + shell_quoted(folder_.string()) +
            " && export AOSCORE_CACHE=\"$PWD/cache\" && cmake -G Ninja -S . -B build -D AOSCORE=" +
            shell_quoted(testing::program()) +
            " >configure.log 2>&1 && ctest --test-dir build --output-on-failure >test.log 2>&1";
        return std::system(command.c_str()) == 0;
    }
    std::string log() const { return read_file(folder_ / "test.log"); }

  private:
    std::filesystem::path folder_;
};

TEST(BuildGate, FailsATestBuildAndNamesTheThresholdThatThenPasses) {
    const std::filesystem::path folder = testing::output_dir();
    Project project(folder);
    const std::string lists = readme_project(), limit = "rmse_debiased>0.2";
    const auto at = lists.find(limit);
    ASSERT_NE(at, std::string::npos) << lists;
    const auto with = [&](const std::string& other) {
        return lists.substr(0, at) + other + lists.substr(at + limit.size());
    };
    ASSERT_TRUE(project.passes(lists)) << project.log();

    ASSERT_FALSE(project.passes(with("rmse_debiased>0.001")));
    const std::string said = project.log();
    EXPECT_THAT(said, HasSubstr("rmse_debiased>0.001: rmse_debiased is 0."));
    EXPECT_THAT(read_file(folder / "build" / "ambient-occlusion.xml"), HasSubstr("<failure message="));
    const auto end = said.find(" would have passed");
    ASSERT_NE(end, std::string::npos) << said;
    const auto begin = said.rfind("; ", end) + 2;
    const std::string passing = said.substr(begin, end - begin);
    EXPECT_THAT(passing, ::testing::StartsWith("rmse_debiased>0."));
    EXPECT_TRUE(project.passes(with(passing))) << project.log();
    EXPECT_THAT(read_file(folder / "build" / "ambient-occlusion.xml"), ::testing::Not(HasSubstr("<failure")));
}

}  // namespace
}  // namespace aoscore
