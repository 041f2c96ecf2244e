// The Debian package that cpack makes, unpacked into a scratch folder: the program must find all that it
// reads there.
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_shell;
using testing::ShellRun;

/// The package, made by cpack in this folder; its path.
fs::path packed(const fs::path& folder) {
    const fs::path build = fs::path(testing::program()).parent_path().parent_path();
    const ShellRun cpack = run_shell("cd '" + folder.string() + "' && cpack -G DEB -B '" + folder.string() +
                                     "' --config '" + (build / "CPackConfig.cmake").string() + "'");
    EXPECT_EQ(cpack.status, 0) << cpack.text;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".deb") return entry.path();
    }
    ADD_FAILURE() << "no package in " << folder << "\n" << cpack.text;
    return {};
}

TEST(Package, RunsFromAScratchFolderWithoutTheSourceTree) {
    const fs::path folder = output_dir(), package = packed(folder), root = folder / "root",
                   home = folder / "home";
    const ShellRun depends = run_shell("dpkg-deb -f '" + package.string() + "' Depends");
    EXPECT_THAT(depends.text, AllOf(HasSubstr("libembree3"), HasSubstr("libopenexr"),
                                    HasSubstr("libopenimageio"), HasSubstr("libosmesa6")));
    ASSERT_EQ(run_shell("dpkg-deb -x '" + package.string() + "' '" + root.string() + "'").status, 0);
    for (const char* file :
         {"usr/bin/aoscore", "usr/lib/aoscore/aoscore-import", "usr/lib/aoscore/aoscore-formats.so",
          "usr/share/man/man1/aoscore-score.1.gz", "usr/share/bash-completion/completions/aoscore",
          "usr/share/doc/aoscore/copyright"})
        EXPECT_TRUE(fs::exists(root / file) || fs::exists((root / file).replace_extension())) << file;
    EXPECT_FALSE(fs::exists(root / "usr/share/aoscore/CMakeLists.txt")) << "it would pass for a source tree";

    // A view file of the user's is found, and what is kept between runs is theirs.
    fs::create_directories(home / ".local/share/aoscore/scenes/mine");
    fs::copy(testing::source_dir() / "scenes/sponza_crytek/views.json",
             home / ".local/share/aoscore/scenes/mine/views.json");
    const std::string aoscore =
        "cd '" + home.string() +
        "' && env -u AOSCORE_CACHE -u AOSCORE_DATA -u XDG_CACHE_HOME -u XDG_DATA_HOME HOME='" +
        home.string() + "' '" + (root / "usr/bin/aoscore").string() + "' ";
    EXPECT_THAT(run_shell(aoscore + "list scenes").text, HasSubstr("\nmine "));
    const ShellRun score =
        run_shell(aoscore + "score plane --view facing --size 64x64 --samples 4 --methods gtao --quiet");
    EXPECT_EQ(score.status, 0) << score.text;
    EXPECT_TRUE(fs::exists(home / "aoscore-out/score-plane/index.html")) << score.text;
    EXPECT_TRUE(fs::exists(home / ".cache/aoscore"));
    const ShellRun import = run_shell(
        "printf 'v 0 0 0\\nv 1 0 0\\nv 0 0 1\\nf 1 2 3\\n' >'" + (home / "t.obj").string() + "'; " + aoscore +
        "reference t.obj --eye 0.3,2,0.3 --target 0.3,0,0.31 --size 16x16 --samples 4 --out t.exr");
    EXPECT_EQ(import.status, 0) << import.text;
}

}  // namespace
}  // namespace aoscore
