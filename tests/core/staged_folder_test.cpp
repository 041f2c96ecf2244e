#include "core/staged_folder.h"

#include "core/error.h"
#include "core/files.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <fstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

TEST(StagedFolder, NothingIsSeenInTheTargetUntilItIsPublished) {
    const fs::path target = testing::output_dir() / "out";
    fs::create_directories(target);
    write_atomically(target / "results.json", "old");
    write_atomically(target / "mine.txt", "the user's own");
    StagedFolder staged(target);
    write_atomically(staged.path() / "results.json", "new");
    write_atomically(staged.path() / "cells" / "a.exr", "image");
    EXPECT_EQ(read_file(target / "results.json"), "old");
    staged.publish();
    EXPECT_EQ(read_file(target / "results.json"), "new");
    EXPECT_EQ(read_file(target / "cells" / "a.exr"), "image");
    EXPECT_EQ(read_file(target / "mine.txt"), "the user's own");
}

TEST(StagedFolder, AnAbandonedRunLeavesNothing) {
    const fs::path target = testing::output_dir() / "out";
    {
        const StagedFolder staged(target);
        write_atomically(staged.path() / "results.json", "half");
    }
    EXPECT_FALSE(fs::exists(target));
}

TEST(StagedFolder, WhatAKilledProcessLeftIsClearedAway) {
    const fs::path target = testing::output_dir() / "out";
    const fs::path orphan = target / ".incomplete-999999999";
    fs::create_directories(orphan);
    const StagedFolder staged(target);
    EXPECT_FALSE(fs::exists(orphan));
}

TEST(StagedFolder, ATargetThatCannotBeMadeIsAFileError) {
    const fs::path file = testing::output_dir() / "file";
    std::ofstream(file) << "no folder";
    try {
        const StagedFolder staged(file / "out");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
    }
}

}  // namespace
}  // namespace aoscore
