// Wrong usage and bad input: clear errors, documented exit codes, nothing written.
#include "image/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

bool holds_only_captures(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        // Stored truths are no output: a stopped run resumes from them.
        if (name != "stdout.txt" && name != "stderr.txt" && name != "truth-cache" &&
            !name.starts_with("input"))
            return false;
    }
    return true;
}

TEST(Usage, WrongUsageExitsWith64) {
    const auto folder = output_dir();
    for (const char* arguments : {"",
                                  "nonsense",
                                  "score",
                                  "score plane --size 12",
                                  "score plane --samples 0",
                                  "reference plane",
                                  "list nonsense",
                                  "compare one",
                                  "bench nonsense",
                                  "score plane --radius -1 --out o",
                                  "score plane --radius 0.5,1 --out o",
                                  "compare a b --fail rmse",
                                  "score plane --view nonsense --out o",
                                  "score nonsense --out o",
                                  "score plane --methods nonsense --out o",
                                  "score plane --preset nonsense --out o",
                                  "score plane --filter nonsense --out o",
                                  "score plane --set nonsense=1 --out o",
                                  "score plane --set radius --out o",
                                  "score plane --set radius=-1 --out o",
                                  "score plane --border nonsense --out o",
                                  "score plane --error 2 --out o",
                                  "run nonsense --out o"}) {
        const ProgramRun run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 64) << arguments << "\n" << run.err;
        EXPECT_FALSE(run.err.empty()) << arguments;
    }
    EXPECT_TRUE(holds_only_captures(folder)) << "wrong usage must write nothing";
}

TEST(Usage, NanIsNoNumber) {
    const auto folder = output_dir();
    for (const std::string number : {"nan", "-nan", "NaN", "inf", "1e999", "0.1x", ""}) {
        for (const std::string option :
             {"run --jobs --scale ", "claims --jobs --scale ", "score plane --out o --error ",
              "score plane --out o --score-error ", "score plane --out o --eye 0,1,1 --target 0,0,0 --fovy ",
              "sweep plane --out o --vary size=64x48 --budget-ms ",
              "tune plane --out o --methods gtao --max-fetches ",
              "tune plane --out o --methods gtao --budget-ms ", "worst plane --out o --methods gtao --height ",
              "export-training plane --out o --height ", "reference plane --out t.exr --mean-error ",
              "compare a.exr b.exr --mask-threshold "}) {
            const ProgramRun run = run_aoscore(option + "'" + number + "'", folder);
            EXPECT_EQ(run.exit_code, 64) << option << number << "\n" << run.err;
        }
    }
    EXPECT_TRUE(holds_only_captures(folder));
}

// These results have no limits, no tables and no baseline: a gate on them would pass whatever they hold.
TEST(Usage, OptionsThatThePageOfAStressTestOrATuningHasNoUseForAreRefused) {
    const auto folder = testing::output_dir();
    for (const char* results : {"stress.json", "tune.json"}) {
        const std::filesystem::path of = folder / std::filesystem::path(results).stem();
        std::filesystem::create_directories(of);
        std::ofstream(of / results) << "{}";
        for (const char* option : {"--fail 'rmse>0.1'", "--warn 'rmse>0.1'", "--export a.csv",
                                   "--baseline nope.json", "--everything"}) {
            const auto run = run_aoscore("page " + of.string() + " " + option, folder);
            EXPECT_EQ(run.exit_code, 64) << results << option << run.err;
            const std::string name = std::string(option).substr(0, std::string(option).find(' '));
            EXPECT_THAT(run.err, ::testing::AllOf(HasSubstr(name), HasSubstr("has no use for it")))
                << results;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST(Usage, UnknownNamesListTheKnownOnes) {
    const auto folder = output_dir();
    EXPECT_THAT(run_aoscore("score nonsense --out o", folder).err, HasSubstr("atrium"));
    EXPECT_THAT(run_aoscore("score plane --methods nonsense --out o", folder).err, HasSubstr("alchemy"));
    EXPECT_THAT(run_aoscore("run nonsense --out o", folder).err, HasSubstr("hussain-table-3"));
}

TEST(Usage, UnknownNamesAskForTheOneThatWasMeant) {
    const auto folder = output_dir();
    const struct {
        const char *arguments, *meant;
    } mistyped[] = {{"scroe plane", "score"},
                    {"score palne --out o", "plane"},
                    {"score wall --view facnig --out o", "facing"},
                    {"score plane --methods gtoa --out o", "gtao"},
                    {"score plane --filter box-4x --out o", "box-4x4"},
                    {"score plane --methods gtao --preset defualt --out o", "default"},
                    {"score plane --methods hbao --set raduis=1 --out o", "radius"},
                    {"score plane --resolution haf --out o", "half"},
                    {"score plane --metohds gtao --out o", "--methods"},
                    {"compare a b --fail 'rsme>0.1'", "rmse"},
                    {"compare a b --fail 'missing_aera>0.1'", "missing_area"},
                    {"run husain-table-3 --out o", "hussain-table-3"},
                    {"stress --axes fov --methods gtoa --out o", "gtao"},
                    {"list mehtods", "methods"},
                    {"cache lst", "list"}};
    for (const auto& [arguments, meant] : mistyped) {
        const ProgramRun run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 64) << arguments << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr(std::string("did you mean ") + meant + "?")) << arguments;
    }
}

TEST(Usage, HelpIsThereInEveryWayThatItIsAskedFor) {
    const auto folder = output_dir();
    for (const char* arguments : {"help", "--help", "-h"}) {
        const ProgramRun run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 0) << arguments;
        EXPECT_THAT(run.out, HasSubstr("compare")) << arguments;
    }
    for (const char* arguments : {"help compare", "compare --help"})
        EXPECT_THAT(run_aoscore(arguments, folder).out, HasSubstr("--mask-threshold")) << arguments;
    const ProgramRun list = run_aoscore("list", folder), nothing = run_aoscore("", folder);
    EXPECT_EQ(list.exit_code, 0);
    EXPECT_THAT(list.out, HasSubstr("scenes, views, methods, metrics, experiments, contestants"));
    // A script whose variable is empty must not succeed.
    EXPECT_EQ(nothing.exit_code, 64);
    EXPECT_THAT(nothing.err, HasSubstr("compare"));
}

TEST(Usage, ListsMayStandBeforeTheScene) {
    const auto folder = output_dir();
    const std::string rest = " --size 32x24 --samples 4 ";
    for (const std::string arguments :
         {"score --methods alchemy,hbao wall --view facing --out a",
          "score --set radius=0.5 sigma=1 wall --view facing --methods alchemy --out b",
          "score --fail 'rmse>2' --warn 'rmse > 2' --methods alchemy wall --view facing --out c",
          "reference --radius 0.5,1 plane --out d.exr"}) {
        const ProgramRun run = run_aoscore(arguments + rest, folder);
        EXPECT_EQ(run.exit_code, 0) << arguments << "\n" << run.err;
    }
}

TEST(Usage, WhatIsWrittenAsExrIsNotCalledOtherwise) {
    const auto folder = output_dir();
    for (const char* command :
         {"gbuffer plane --size 16x16 --out g.png", "reference plane --size 16x16 --out t.png",
          "gbuffer plane --size 16x16 --out g"}) {
        const ProgramRun run = run_aoscore(command, folder);
        EXPECT_EQ(run.exit_code, 64) << command;
        EXPECT_THAT(run.err, HasSubstr(".exr")) << command;
    }
    EXPECT_TRUE(holds_only_captures(folder));
}

TEST(Usage, HelpNamesEveryExitCodeAndExitsWith0) {
    const ProgramRun run = run_aoscore("--help", output_dir());
    EXPECT_EQ(run.exit_code, 0);
    for (const char* code : {"0 ok", "1 a --warn", "2 a --fail", "3 sizes", "4 a file", "5 some cells",
                             "64 wrong", "70 ", "130 "}) {
        EXPECT_THAT(run.out, HasSubstr(code));
    }
}

TEST(Usage, BadFilesExitWith4AndWriteNothing) {
    const auto folder = output_dir();
    std::ofstream(folder / "input_garbage.glb") << "this is no glTF";
    std::ofstream(folder / "input_garbage.exr") << "this is no image";
    for (const char* arguments :
         {"score missing.glb --out o", "score input_garbage.glb --out o",
          "reference missing.gltf --out t.exr", "gbuffer input_garbage.glb --out g.exr",
          "compare missing.exr missing.exr --json j.json",
          "compare input_garbage.exr input_garbage.exr --json j.json"}) {
        const ProgramRun run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 4) << arguments << "\n" << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << "one line: " << run.err;
    }
    EXPECT_TRUE(holds_only_captures(folder));
}

TEST(Usage, OutputThatCannotBeWrittenExitsWith4) {
    const auto folder = output_dir();
    std::ofstream(folder / "input_file") << "a file where a folder is asked for";
    const ProgramRun run = run_aoscore("score plane --view facing --size 16x16 --out input_file/out", folder);
    EXPECT_EQ(run.exit_code, 4) << run.err;
}

// OpenImageIO brings some 250 libraries; the dynamic linker tells with LD_DEBUG which it loads.
TEST(Usage, OpenImageIoIsLoadedByCommandsThatReadAnImageOfAnotherFormatAlone) {
    const auto folder = output_dir();
    const auto loads_it = [&](const char* command) {
        const ProgramRun run = run_aoscore(command, folder, "env LD_DEBUG=files");
        EXPECT_EQ(run.exit_code, 0) << command;
        return run.err.find("libOpenImageIO.so") != std::string::npos;
    };
    EXPECT_FALSE(loads_it("--version"));
    EXPECT_FALSE(loads_it("list methods"));
    EXPECT_FALSE(loads_it("reference plane --view facing --size 16x16 --samples 4 --out t.exr"));
    EXPECT_FALSE(loads_it("compare t.exr t.exr")) << "OpenEXR alone reads a plain EXR";
    const Image<std::uint8_t> gray(16, 16, 200);
    std::ofstream(folder / "t.png", std::ios::binary) << encode_png_gray(gray);
    EXPECT_TRUE(loads_it("compare t.png t.png --linear"));
}

TEST(Usage, CtrlCEndsTheRunWith130AndLeavesNothing) {
    const auto folder = output_dir();
    const ProgramRun run =
        run_aoscore("score sphere --samples 100000 --out o", folder, "timeout --preserve-status -s INT 3");
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_TRUE(holds_only_captures(folder)) << "a stopped run must leave nothing";
}

}  // namespace
}  // namespace aoscore
