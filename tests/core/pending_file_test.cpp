// A written file appears in its place at once, also through a link, or passes through a device.
#include "core/pending_file.h"

#include "core/error.h"
#include "core/files.h"
#include "core/staged_folder.h"
#include "support/support.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <thread>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;

std::string error_of_writing(const fs::path& path) {
    try {
        write_atomically(path, "content");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        return e.what();
    }
    return "no error";
}

std::size_t entries_of(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Makes a device of the test's own, since tests must not touch /dev.
bool make_device(const fs::path& path, unsigned minor) {
    if (mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor)) != 0) return false;
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return descriptor >= 0 && close(descriptor) == 0;
}
constexpr unsigned kNull = 3, kFull = 7;

TEST(WrittenFile, ReplacesARegularFileAndLeavesNothingElse) {
    const fs::path folder = output_dir();
    write_atomically(folder / "file", "old");
    write_atomically(folder / "file", "new");
    EXPECT_EQ(read_file(folder / "file"), "new");
    EXPECT_EQ(entries_of(folder), 1U);
}

TEST(WrittenFile, FollowsALinkWhetherItsTargetIsThereOrNot) {
    const fs::path folder = output_dir();
    fs::create_directories(folder / "there");
    for (const char* target : {"there/file", "there/other"}) {
        fs::remove(folder / "link");
        fs::create_symlink(target, folder / "link");
        if (std::string(target) == "there/file") write_atomically(folder / target, "old");
        write_atomically(folder / "link", "new");
        EXPECT_TRUE(fs::is_symlink(folder / "link"));
        EXPECT_EQ(read_file(folder / target), "new");
    }
}

TEST(WrittenFile, OfAStagedFolderFollowsALinkToo) {
    const fs::path folder = output_dir();
    fs::create_directories(folder / "out");
    write_atomically(folder / "elsewhere.json", "old");
    fs::create_symlink("../elsewhere.json", folder / "out" / "results.json");
    StagedFolder staged(folder / "out");
    write_atomically(staged.path() / "results.json", "new");
    staged.publish();
    EXPECT_TRUE(fs::is_symlink(folder / "out" / "results.json"));
    EXPECT_EQ(read_file(folder / "elsewhere.json"), "new");
}

TEST(WrittenFile, ACircleOfLinksAndAFolderAreErrors) {
    const fs::path folder = output_dir();
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    EXPECT_THAT(error_of_writing(folder / "a"), HasSubstr("circle"));
    fs::create_directories(folder / "folder");
    EXPECT_THAT(error_of_writing(folder / "folder"), HasSubstr("is a folder"));
}

TEST(WrittenFile, GoesThroughADeviceWhichStaysOne) {
    const fs::path folder = output_dir();
    if (!make_device(folder / "null", kNull)) GTEST_SKIP() << "devices can be made by root alone";
    write_atomically(folder / "null", "content");
    fs::create_symlink("null", folder / "link");
    write_atomically(folder / "link", "content");
    EXPECT_TRUE(fs::is_character_file(folder / "null"));
    EXPECT_EQ(entries_of(folder), 2U);
}

TEST(WrittenFile, OnAFullDeviceIsAnErrorThatSaysSo) {
    const fs::path folder = output_dir();
    if (!make_device(folder / "full", kFull)) GTEST_SKIP() << "devices can be made by root alone";
    EXPECT_THAT(error_of_writing(folder / "full"), HasSubstr("No space left"));
    EXPECT_TRUE(fs::is_character_file(folder / "full"));
}

TEST(WrittenFile, GoesThroughAPipeToItsReader) {
    const fs::path folder = output_dir(), pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
    const std::string content(300'000, 'x');  // more than a pipe holds
    std::string read;
    std::thread reader([&] {
        std::ostringstream all;
        all << std::ifstream(pipe).rdbuf();
        read = all.str();
    });
    write_atomically(pipe, content);
    reader.join();
    EXPECT_EQ(read, content);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace aoscore
