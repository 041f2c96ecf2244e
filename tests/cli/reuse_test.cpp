// Earlier measurements are not repeated, and no other is taken for them.
#include "core/files.h"
#include "core/folders.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <set>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;

/// Runs the program in the test's folder with a cache of the test's own.
Results results_of(const std::string& arguments, const fs::path& folder, std::string* said = nullptr) {
    const auto run = testing::run_aoscore(arguments + " --out out", folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    if (said != nullptr) *said = run.err;
    return run.exit_code == 0 ? read_results(folder / "out") : Results();
}

void expect_same_numbers(const Results& a, const Results& b) {
    ASSERT_EQ(a.cells.size(), b.cells.size());
    for (std::size_t i = 0; i < a.cells.size(); ++i) {
        EXPECT_EQ(a.cells[i].id, b.cells[i].id);
        for (const auto& [id, measured] : a.cells[i].ranked)
            EXPECT_EQ(measured.value, b.cells[i].ranked.at(id).value) << a.cells[i].id << " " << id;
        EXPECT_EQ(a.cells[i].fetches_per_pixel, b.cells[i].fetches_per_pixel);
    }
}

const std::string kSweep =
    "sweep wall --view facing --methods alchemy,hbao --vary samples=2,4 --vary directions=2,4 --size 48x32 "
    "--samples 8";

TEST(Reuse, ASecondRunTracesDrawsAndCompilesNothing) {
    const auto folder = output_dir();
    std::string said;
    const Results cold = results_of(kSweep, folder, &said);
    EXPECT_THAT(said, HasSubstr("0 measured before, 4 to do"));
    EXPECT_GT(cold.work.rays, 0u);
    EXPECT_EQ(cold.work.gbuffers, 1u) << "no G-buffer is drawn twice";
    // Each cell has a shader that draws and one that counts; the fixed pass and the lighting draw.
    EXPECT_LE(cold.work.compilations, 2 * 4 + 2u + 3u) << "no program is compiled twice";
    EXPECT_EQ(cold.work.cells_measured, 4u);
    const Results warm = results_of(kSweep, folder, &said);
    EXPECT_THAT(said, HasSubstr("all measured before"));
    EXPECT_EQ(warm.work.rays, 0u);
    EXPECT_EQ(warm.work.gbuffers, 0u);
    EXPECT_EQ(warm.work.passes, 0u);
    EXPECT_EQ(warm.work.compilations, 0u);
    EXPECT_EQ(warm.work.cells_reused, 4u);
    expect_same_numbers(cold, warm);
    for (std::size_t i = 0; i < cold.cells.size(); ++i)
        EXPECT_EQ(cold.cells[i].ao.runs_ms, warm.cells[i].ao.runs_ms);
}

TEST(Reuse, ALargerSweepMeasuresOnlyWhatIsNew) {
    const auto folder = output_dir();
    results_of(kSweep, folder);
    const Results more = results_of(
        "sweep wall --view facing --methods alchemy,hbao --vary samples=2,4,8 --vary directions=2,4 --size "
        "48x32 "
        "--samples 8",
        folder);
    EXPECT_EQ(more.work.cells_measured, 1u);
    EXPECT_EQ(more.work.cells_reused, 4u);
}

TEST(Reuse, AFinerTruthDrawsAndTimesNothingAgain) {
    const auto folder = output_dir();
    const std::string score = "score wall --view facing --methods hbao,alchemy --size 48x32 --samples ";
    const Results coarse = results_of(score + "4", folder);
    const Results fine = results_of(score + "8", folder);
    EXPECT_EQ(fine.work.passes, 0u);
    EXPECT_EQ(fine.work.compilations, 0u);
    EXPECT_EQ(fine.work.cells_measured, 2u) << "they are scored again";
    for (std::size_t i = 0; i < fine.cells.size(); ++i) {
        EXPECT_EQ(fine.cells[i].ao.runs_ms, coarse.cells[i].ao.runs_ms);
        EXPECT_EQ(fine.cells[i].fetches_per_pixel, coarse.cells[i].fetches_per_pixel);
    }
    // The numbers are those of a run that drew everything itself.
    expect_same_numbers(fine, results_of(score + "8 --no-cache", folder));
}

TEST(Reuse, AnotherRadiusOfTheRankingDrawsNothingAgainWhereLengthsStay) {
    const auto folder = output_dir();
    const std::string score =
        "score wall --view facing --methods hbao --own-parameters --size 48x32 --samples 4 --radius ";
    results_of(score + "0.5", folder);
    const Results wider = results_of(score + "0.8", folder);
    EXPECT_EQ(wider.work.passes, 0u);
    EXPECT_EQ(wider.work.cells_measured, 1u);
}

std::set<std::string> keys_of(const std::string& kind, const std::string& command, const fs::path& folder) {
    const auto run = testing::run_aoscore(command + " --jobs", folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const nlohmann::json list = nlohmann::json::parse(run.out);
    std::set<std::string> keys;
    for (const nlohmann::json& job : list.at("jobs")) {
        if (job.at("kind") == kind) keys.insert(job.at("key").get<std::string>());
    }
    return keys;
}

TEST(Reuse, ASweepUsesTheImagesAndFetchesOfAScore) {
    const auto folder = output_dir();
    const std::string of_all = " wall --view facing --methods hbao --size 48x32 --samples 8";
    for (const char* kind : {"image", "fetches"}) {
        const std::set<std::string> score = keys_of(kind, "score" + of_all, folder);
        ASSERT_EQ(score.size(), 1u);
        EXPECT_THAT(keys_of(kind, "sweep" + of_all + " --vary directions=4,8", folder),
                    ::testing::Contains(*score.begin()))
            << kind << " of the preset's own four directions";
    }
}

TEST(Reuse, WhatDecidesANumberIsInItsKey) {
    const auto folder = output_dir();
    results_of(kSweep, folder);
    for (const std::string change :
         {"--radius 0.7", "--seed 2", "--set sigma=0.2 --set bias=0.1", "--filter none"})
        EXPECT_EQ(results_of(kSweep + " " + change, folder).work.cells_measured, 4u) << change;
    EXPECT_EQ(results_of(kSweep + " --no-cache", folder).work.cells_reused, 0u);
}

TEST(Reuse, APageOfPicturesComesBackWhole) {
    const auto folder = output_dir();
    const std::string score = "score wall --view facing --methods alchemy --size 48x32 --samples 8";
    const Results cold = results_of(score, folder);
    const std::string picture = read_file(folder / "out" / cold.cells.at(0).image_file);
    EXPECT_EQ(results_of(score, folder).work.passes, 0u);
    fs::remove_all(folder / "out");
    const Results warm = results_of(score, folder);
    EXPECT_GT(warm.work.passes, 0u) << "images lie in the results alone, and are drawn again without them";
    EXPECT_EQ(warm.work.cells_measured, 0u);
    EXPECT_EQ(warm.work.rays, 0u);
    EXPECT_EQ(read_file(folder / "out" / warm.cells.at(0).image_file), picture);
    EXPECT_TRUE(fs::exists(folder / "out" / warm.views.at(0).truth_file));
    EXPECT_TRUE(fs::exists(folder / "out/index.html"));
    expect_same_numbers(cold, warm);
}

TEST(Reuse, AnImageOfTheResultsIsTakenFromWhereverTheyLie) {
    const auto folder = output_dir();
    const std::string score = "score wall --view facing --methods alchemy --size 48x32 --samples 8";
    const Results first = results_of(score, folder);
    for (const auto& file : fs::recursive_directory_iterator(folder / "truth-cache"))
        EXPECT_NE(file.path().extension(), ".exr") << "a second copy of what the results hold";
    ASSERT_EQ(testing::run_aoscore(score + " --out elsewhere", folder).exit_code, 0);
    EXPECT_EQ(read_results(folder / "elsewhere").work.passes, 0u);
    EXPECT_EQ(read_file(folder / "elsewhere" / first.cells.at(0).image_file),
              read_file(folder / "out" / first.cells.at(0).image_file));
}

TEST(Reuse, AnEditedShaderRepeatsItsOwnMethodOnly) {
    const auto folder = output_dir();
    for (const char* name : {"mine-a", "mine-b"}) {
        fs::create_directories(folder / "methods");
        fs::copy(data_dir() / "shaders" / "methods" / "alchemy", folder / "methods" / name,
                 fs::copy_options::recursive);
    }
    const std::string sweep =
        "sweep wall --view facing --methods mine-a,mine-b --vary samples=2,4 --size 48x32 --samples 8 "
        "--methods-dir "
        "methods";
    EXPECT_EQ(results_of(sweep, folder).work.cells_measured, 4u);
    EXPECT_EQ(results_of(sweep, folder).work.cells_measured, 0u);
    const fs::path shader = folder / "methods" / "mine-b" / "ao.frag";
    std::string text = read_file(shader);
    const std::size_t at = text.find("max(0.0, 1.0");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 12, "max(0.1, 1.0");
    std::ofstream(shader) << text;
    const Results edited = results_of(sweep, folder);
    EXPECT_EQ(edited.work.cells_measured, 2u);
    EXPECT_EQ(edited.work.cells_reused, 2u);
    // Two cells, each drawn for its metrics and its fetches and then timed; its twin is not touched.
    EXPECT_LE(edited.work.compilations, 2 * 2 + 2u + 2u);
}

TEST(Reuse, ADamagedEntryIsSaidAndMeasuredAgain) {
    const auto folder = output_dir();
    const Results cold = results_of(kSweep, folder);
    const fs::path store = folder / "truth-cache" / "measurements";
    ASSERT_TRUE(fs::is_directory(store));
    for (const auto& file : fs::recursive_directory_iterator(store)) {
        if (file.is_regular_file()) std::ofstream(file.path()) << "not what it was";
    }
    std::string said;
    const Results again = results_of(kSweep, folder, &said);
    EXPECT_THAT(said, HasSubstr("damaged"));
    EXPECT_EQ(again.work.cells_measured, 4u);
    expect_same_numbers(cold, again);
}

}  // namespace
}  // namespace aoscore
