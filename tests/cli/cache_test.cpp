// Tests the cache of truths through the program.
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kReference = "reference pillar --size 96x64 --radius 0.5,2 --samples 64 --causes";

void expect_same_pictures(const fs::path& a, const fs::path& b) {
    const ImageFile one = read_image(a), two = read_image(b);
    ASSERT_EQ(one.channel_names, two.channel_names);
    for (const std::string& name : one.channel_names)
        EXPECT_EQ(one.channel(name)->pixels, two.channel(name)->pixels) << name;
}

std::size_t cached_files(const fs::path& folder) {
    std::size_t count = 0;
    if (!fs::exists(folder / "truth-cache")) return 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "truth-cache"))
        count += entry.is_regular_file();
    return count;
}

TEST(CacheCommand, ASecondCallReadsWhatTheFirstTraced) {
    const auto folder = output_dir();
    const std::string reference = kReference;
    ASSERT_EQ(run_aoscore(reference + " --no-cache --out none.exr", folder).exit_code, 0);
    EXPECT_EQ(cached_files(folder), 0U) << "--no-cache leaves nothing";
    ASSERT_EQ(run_aoscore(reference + " --out one.exr", folder).exit_code, 0);
    EXPECT_EQ(cached_files(folder), 1U);
    const auto second = run_aoscore(reference + " --out two.exr", folder);
    EXPECT_THAT(second.err, HasSubstr("from the cache"));
    expect_same_pictures(folder / "one.exr", folder / "two.exr");
    expect_same_pictures(folder / "none.exr", folder / "two.exr");
    const auto without = run_aoscore(reference + " --no-cache --out three.exr", folder);
    EXPECT_THAT(without.err, Not(HasSubstr("from the cache")));
}

TEST(CacheCommand, ListVerifyAndClearSayWhatTheyFind) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore(std::string(kReference) + " --out one.exr", folder).exit_code, 0);
    const auto list = run_aoscore("cache list", folder);
    for (const char* part : {"pillar", "96x64", "binary 0.5 m", "binary 2 m", "causes", "64 samples", "MiB",
                             "old", "complete", "1 truths"}) {
        EXPECT_THAT(list.out, HasSubstr(part));
    }
    const auto good = run_aoscore("cache verify", folder);
    EXPECT_EQ(good.exit_code, 0) << good.out;
    EXPECT_THAT(good.out, HasSubstr("4 parts traced again, 0 differ"));

    fs::path file;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "truth-cache"))
        if (entry.is_regular_file()) file = entry.path();
    {
        std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2));
        bytes << "damage";
    }
    const auto bad = run_aoscore("cache verify", folder);
    EXPECT_EQ(bad.exit_code, 4);
    EXPECT_THAT(bad.out, HasSubstr("BAD"));
    const auto cleared = run_aoscore("cache clear", folder);
    EXPECT_THAT(cleared.out, HasSubstr("1 truths removed"));
    EXPECT_EQ(cached_files(folder), 0U);
}

TEST(CacheCommand, TwoProcessesTraceOneTruthOnce) {
    const auto folder = output_dir();
    const std::string reference = "reference pillar --size 192x128 --radius 2 --samples 256 --causes --out ";
    fs::create_directories(folder / "a");
    fs::create_directories(folder / "b");
    // Both use the cache of the folder above.
    const std::string prefix = "env AOSCORE_CACHE='" + (folder / "both").string() + "'";
    testing::ProgramRun a, b;
    std::thread other([&] { a = run_aoscore(reference + "t.exr", folder / "a", prefix); });
    b = run_aoscore(reference + "t.exr", folder / "b", prefix);
    other.join();
    ASSERT_EQ(a.exit_code, 0) << a.err;
    ASSERT_EQ(b.exit_code, 0) << b.err;
    expect_same_pictures(folder / "a/t.exr", folder / "b/t.exr");
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "both"))
        files += entry.is_regular_file();
    EXPECT_EQ(files, 1U);
}

TEST(CacheCommand, AnInterruptedReferenceKeepsWhatIsDoneAndGoesOn) {
    const auto folder = output_dir();
    const std::string reference = "reference pillar --size 320x200 --radius 2 --samples 1024 --causes --out ";
    ASSERT_EQ(run_aoscore(reference + "undisturbed.exr --no-cache", folder).exit_code, 0);
    // The run is killed after ever longer times, until it finishes: some of these stop it in the middle.
    int runs = 0, exit_code = 1;
    for (double seconds = 0.3; exit_code != 0 && runs < 60; ++runs, seconds *= 1.2) {
        exit_code =
            run_aoscore(reference + "resumed.exr", folder, "timeout -s KILL " + std::to_string(seconds))
                .exit_code;
    }
    ASSERT_EQ(exit_code, 0);
    expect_same_pictures(folder / "undisturbed.exr", folder / "resumed.exr");
}

TEST(CacheCommand, AScoreSaysWhereItsTruthComesFrom) {
    const auto folder = output_dir();
    const std::string score = "score pillar --view main --methods alchemy --size 96x64 --out page";
    std::vector<ViewRecord> views;
    // From 64 rays on pixels that are proven to be open count no rays, so that only from there on rays add up.
    for (const char* samples : {" --samples 64", " --samples 64", " --samples 32", " --samples 128"}) {
        const auto run = run_aoscore(score + samples, folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        views.push_back(read_results(folder / "page").views.at(0));
    }
    EXPECT_EQ(views[0].truth_origin, "traced");
    EXPECT_EQ(views[0].truth_rays_now, views[0].truth_rays);
    EXPECT_EQ(views[1].truth_origin, "cached");
    EXPECT_EQ(views[1].truth_rays_now, 0U);
    EXPECT_EQ(views[1].truth_rays, views[0].truth_rays);
    EXPECT_EQ(views[2].truth_origin, "cached");
    EXPECT_EQ(views[2].samples, 64) << "the samples really used";
    EXPECT_EQ(views[3].truth_origin, "refined");
    EXPECT_EQ(views[3].truth_rays_now, views[3].truth_rays - views[0].truth_rays);
}

TEST(TruthFile, SaysTheCommandThatMakesItAgain) {
    const auto folder = output_dir();
    const auto folder_again = folder / "again";
    fs::create_directories(folder_again);
    const std::string arguments[] = {
        "reference pillar --view main --size 96x64 --radius 0.5,inf --samples 16 --causes --one-layer-bound "
        "--bent-normals --seed 7",
        "reference pillar --view main --size 96x64 --radius 0.5,inf --error 0.05 --seed 7",
        // The earlier truth serves this one: its command must make that truth.
        "reference pillar --view main --size 96x64 --radius 0.5,inf --error 0.1 --seed 7",
    };
    for (const std::string& call : arguments) {
        ASSERT_EQ(run_aoscore(call + " --out 'a truth.exr'", folder).exit_code, 0);
        const ImageFile file = read_image(folder / "a truth.exr");
        const std::string command = file.attributes.at("comments");
        ASSERT_EQ(command.substr(0, 8), "aoscore ");
        const auto again = run_aoscore(command.substr(8), folder_again);
        ASSERT_EQ(again.exit_code, 0) << command << again.err;
        expect_same_pictures(folder / "a truth.exr", folder_again / "a truth.exr");
        const ImageFile second = read_image(folder_again / "a truth.exr");
        for (const auto& [name, value] : file.attributes) {
            if (name == "capDate") continue;
            EXPECT_EQ(second.attributes.at(name), value) << name;
        }
        for (const char* name :
             {"aoscore:seed", "aoscore:samples", "aoscore:max_error", "aoscore:scene_digest",
              "aoscore:version", "aoscore:integrator", "aoscore:V0.radius_m", "aoscore:V1.falloff", "capDate",
              "worldToCamera", "worldToNDC"}) {
            EXPECT_TRUE(file.attributes.contains(name)) << name;
        }
    }
}

}  // namespace
}  // namespace aoscore
