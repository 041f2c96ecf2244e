#include "store/artifact_store.h"

#include "core/files.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kKey = "0123456789abcdef0123456789abcdef";

fs::path only_file(const fs::path& folder, const std::string& extension) {
    for (const auto& file : fs::recursive_directory_iterator(folder)) {
        if (file.path().extension() == extension) return file.path();
    }
    return {};
}

TEST(ArtifactStore, FindsWhatWasPutAndNothingElse) {
    const ArtifactStore store(testing::output_dir());
    EXPECT_FALSE(store.find(kKey));
    store.put(kKey, {{"a", 0.1}, {"b", {1, 2}}});
    EXPECT_EQ(store.find(kKey), json({{"a", 0.1}, {"b", {1, 2}}}));
    EXPECT_FALSE(store.find("f" + kKey.substr(1)));
}

/// A file that was put from `staged`, and then moved to `published`.
struct Published {
    fs::path folder = testing::output_dir();
    fs::path staged = folder / "staged", published = folder / "published";
    ArtifactStore store{folder / "store"};

    Published() {
        write_atomically(staged / "cells/a.exr", "a picture");
        store.put_file(kKey, staged / "cells/a.exr");
        fs::create_directories(published / "cells");
        fs::rename(staged / "cells/a.exr", published / "cells/a.exr");
    }
};

TEST(ArtifactStore, KeepsNoCopyOfWhatIsPublished) {
    const Published p;
    p.store.settle(p.staged, p.published);
    EXPECT_EQ(only_file(p.folder / "store", ".exr"), fs::path());
    ASSERT_EQ(p.store.file(kKey), fs::absolute(p.published / "cells/a.exr"));
    ASSERT_TRUE(p.store.fetch_file(kKey, p.folder / "again.exr"));
    EXPECT_EQ(read_file(p.folder / "again.exr"), "a picture");
}

TEST(ArtifactStore, MissesAPublishedFileThatWasChangedOrRemovedAndCallsNothingDamaged) {
    const Published p;
    p.store.settle(p.staged, p.published);
    std::ofstream(p.published / "cells/a.exr") << "another picture";
    EXPECT_FALSE(p.store.file(kKey));
    fs::remove(p.published / "cells/a.exr");
    EXPECT_FALSE(p.store.file(kKey));
    EXPECT_THAT(p.store.damaged(), IsEmpty());
}

TEST(ArtifactStore, ForgetsAFileInWhosePlaceALaterOneWasPublished) {
    const Published p;
    std::ofstream(p.published / "cells/a.exr") << "one of more rays";
    p.store.settle(p.staged, p.published);
    EXPECT_FALSE(p.store.has(kKey));
    EXPECT_EQ(p.store.size().bytes, 0U);
}

TEST(ArtifactStore, WithoutAFolderKeepsNothing) {
    const ArtifactStore store{fs::path()};
    store.put(kKey, 1);
    EXPECT_FALSE(store.find(kKey));
}

TEST(ArtifactStore, ADamagedEntryCountsAsMissingHoweverItWasDamaged) {
    const fs::path folder = testing::output_dir();
    const ArtifactStore store(folder);
    store.put(kKey, {{"value", 12345}});
    const fs::path file = only_file(folder, ".json");
    const std::string whole = read_file(file);
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        std::ofstream(file, std::ios::binary) << whole.substr(0, length);
        EXPECT_FALSE(store.find(kKey)) << length;
    }
    std::string changed = whole;
    changed[changed.find("12345")] = '9';
    std::ofstream(file, std::ios::binary) << changed;
    EXPECT_FALSE(store.find(kKey)) << "a digit that turned";
    EXPECT_THAT(store.damaged(), SizeIs(1));
    store.put(kKey, {{"value", 12345}});
    EXPECT_TRUE(store.find(kKey)) << "it is mended by being made again";
    EXPECT_THAT(store.damaged(), IsEmpty());
}

TEST(ArtifactStore, AnEntryUnderAnotherKeyIsNotBelieved) {
    const fs::path folder = testing::output_dir();
    const ArtifactStore store(folder);
    store.put(kKey, 1);
    const std::string other = kKey.substr(0, 31) + "0";
    fs::copy_file(folder / "01" / (kKey + ".json"), folder / "01" / (other + ".json"));
    EXPECT_FALSE(store.find(other));
}

TEST(ArtifactStore, FilesComeBackBitForBitOrNotAtAll) {
    const fs::path folder = testing::output_dir();
    const ArtifactStore store(folder / "store");
    write_atomically(folder / "picture.exr", std::string("bits\0of it", 10));
    store.put_file(kKey, folder / "picture.exr");
    ASSERT_TRUE(store.fetch_file(kKey, folder / "back" / "picture.exr"));
    EXPECT_EQ(read_file(folder / "back" / "picture.exr"), read_file(folder / "picture.exr"));
    std::ofstream(only_file(folder / "store", ".exr"), std::ios::app) << "more";
    EXPECT_FALSE(store.fetch_file(kKey, folder / "back" / "picture.exr"));
    EXPECT_THAT(store.damaged(), SizeIs(1));
}

TEST(ArtifactStore, ManyWritersOfOneKeyLeaveOneWholeEntry) {
    const ArtifactStore store(testing::output_dir());
    const json payload = std::vector<int>(5000, 7);
    std::vector<std::thread> writers;
    for (int i = 0; i < 4; ++i) {
        writers.emplace_back([&] {
            for (int k = 0; k < 20; ++k) {
                store.put(kKey, payload);
                EXPECT_EQ(store.find(kKey), payload) << "never half of it";
            }
        });
    }
    for (std::thread& writer : writers) writer.join();
    EXPECT_THAT(store.damaged(), IsEmpty());
}

}  // namespace
}  // namespace aoscore
