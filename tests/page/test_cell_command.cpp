#include "image/image_file.h"
#include "page/sections/cell_command.h"
#include "results/results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

/// The command of a cell alone, held to what it is for: run, it measures the same numbers.
namespace aoscore {
namespace {

namespace fs = std::filesystem;

std::string without_program(const std::string& command) {
    const std::string program = "aoscore ";
    EXPECT_TRUE(command.starts_with(program)) << command;
    return command.substr(program.size());
}

TEST(CellCommand, MeasuresTheCellsNumbersAlone) {
    const fs::path folder = testing::output_dir();
    const std::string arguments =
        "--seed 7 score atrium --view wide --methods ssao,hbao --size 96x54 "
        "--samples 16 --radius 0.4 --set radius=0.3 --set filter.taps=3 "
        "--resolution half --filter gaussian-depth --quiet --out ";
    ASSERT_EQ(testing::run_aoscore(arguments + "all", folder).exit_code, 0);
    const Results all = read_results(folder / "all");
    ASSERT_EQ(all.cells.size(), 2U);
    for (const CellRecord& cell : all.cells) {
        const std::string command = cell_command(all, all.views.front(), cell);
        ASSERT_NE(command, all.command);
        ASSERT_EQ(testing::run_aoscore(without_program(command) + " --quiet --out " + cell.method, folder)
                      .exit_code,
                  0)
            << command;
        const Results alone = read_results(folder / cell.method);
        ASSERT_EQ(alone.cells.size(), 1U);
        EXPECT_EQ(alone.cells[0].id, cell.id) << command;
        EXPECT_EQ(alone.cells[0].parameters, cell.parameters) << command;
        for (const auto& [id, measured] : cell.ranked)
            EXPECT_EQ(alone.cells[0].ranked.at(id).value, measured.value) << id << ": " << command;
    }
}

TEST(CellCommand, LightsTheCellAsTheRunDid) {
    const fs::path folder = testing::output_dir();
    const ImageF dim(8, 4, 0.5F), bright(8, 4, 2);
    write_exr(folder / "light.exr", std::vector<ChannelView>{{"R", &bright}, {"G", &dim}, {"B", &dim}}, {});
    for (const std::string light : {"sky", "light.exr --environment-turn 30"}) {
        const std::string score =
            "score sphere --view facing --methods gtao,alchemy --size 48x27 --samples 16 ";
        ASSERT_EQ(testing::run_aoscore(score + "--environment " + light + " --out all", folder).exit_code, 0);
        const Results all = read_results(folder / "all");
        const std::string command = cell_command(all, all.views.front(), all.cells.front());
        ASSERT_EQ(testing::run_aoscore(without_program(command) + " --out alone", folder).exit_code, 0);
        const Results alone = read_results(folder / "alone");
        ASSERT_TRUE(alone.views.front().light) << command;
        EXPECT_EQ(alone.views.front().light->environment, all.views.front().light->environment) << command;
        EXPECT_EQ(to_json(alone.cells.at(0)).at("light"), to_json(all.cells.front()).at("light")) << command;
    }
}

CellRecord cell_of(const std::string& id) {
    CellRecord cell;
    cell.view_key = "hall/door";
    cell.method = "hbao";
    cell.preset = "quality";
    cell.filter = "box-4x4";
    cell.id = "hall/door/hbao/quality" + id;
    return cell;
}

struct CommandCase {
    std::string addition, options;
};

class CellCommandOptions : public ::testing::TestWithParam<CommandCase> {};

TEST_P(CellCommandOptions, FollowFromTheCellsId) {
    Results results;
    ViewRecord view;
    view.radius_m = 0.5;
    view.truth_command =
        "aoscore reference 'my hall.glb' --view door --unit cm --size 640x360 --radius 0.5,2 "
        "--samples 64 --seed 1 --no-cache --out x.exr";
    const auto& [addition, options] = GetParam();
    EXPECT_EQ(cell_command(results, view, cell_of(addition)),
              "aoscore score 'my hall.glb' --view door --unit cm --size 640x360 --radius 0.5 --samples 64 "
              "--methods hbao --preset quality" +
                  options);
}

INSTANTIATE_TEST_SUITE_P(
    All, CellCommandOptions,
    ::testing::Values(CommandCase{"", ""}, CommandCase{"/box-4x4", " --filter box-4x4"},
                      CommandCase{"/steps=8,noise=hash", " --set steps=8 --set noise=hash"},
                      CommandCase{"/box-4x4/guard-band=10%,signal=bent_normal",
                                  " --filter box-4x4 --guard-band 10% --signals bent_normal"}));

TEST(CellCommand, IsTheRunsWhereACellCannotBeAskedForAlone) {
    ViewRecord view;
    view.truth_command = "aoscore reference atrium --size 8x8 --radius 1 --samples 4 --seed 1 --out x.exr";
    Results images, file;
    images.command = "aoscore score atrium --contestant mine --out x";
    EXPECT_EQ(cell_command(images, view, cell_of("")), images.command);
    file.command = "aoscore score atrium --methods gtao --preset tuned/gtao.json --out x";
    EXPECT_EQ(cell_command(file, view, cell_of("")), file.command);
    Results accuracy;
    view.score_error = 0.002;
    EXPECT_EQ(
        cell_command(accuracy, view, cell_of("")),
        "aoscore score atrium --size 8x8 --radius 0 --score-error 0.002 --methods hbao --preset quality");
}

}  // namespace
}  // namespace aoscore
