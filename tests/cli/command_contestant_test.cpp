// Methods of other programs that a command draws: what it is handed, and what becomes of one that fails.
#include "core/files.h"
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScored = "score wall --view oblique --size 64x48 --samples 8 --methods alchemy";

const CellRecord& row_of(const Results& results, const std::string& method,
                         const std::string& preset = "default") {
    return *std::ranges::find_if(results.cells, [&](const CellRecord& cell) {
        return cell.method == method && cell.preset == preset;
    });
}

class CommandContestant : public ::testing::Test {
  protected:
    /// The image of a method, for commands to copy.
    void SetUp() override {
        const auto run = run_aoscore(std::string(kScored) + " --out first", folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        method = row_of(read_results(folder / "first"), "alchemy");
        write_atomically(folder / "engine/ao.sh", "");
        keep(*read_image(folder / "first" / method.image_file).channel("Y"));
    }

    void keep(const ImageF& image) const {
        const ChannelView channel{"Y", &image};
        write_exr(folder / "engine/kept.exr", std::span(&channel, 1), {});
    }

    /// Describes a command that runs this script, with further members.
    void describe(const std::string& script, const nlohmann::json& more = nlohmann::json::object()) const {
        write_atomically(folder / "engine/ao.sh", script);
        nlohmann::json command = {
            {"words", {"sh", "{folder}/ao.sh", "{folder}", "{output}", "{request}", "{radius_m}"}},
            {"files", {"ao.sh", "kept.exr"}},
            {"version", "1"}};
        command.update(more);
        write_atomically(folder / "engine/contestant.json", nlohmann::json({{"id", "engine"},
                                                                            {"label", "My engine"},
                                                                            {"encoding", "linear"},
                                                                            {"signal", "visibility"},
                                                                            {"channel", "Y"},
                                                                            {"command", command}})
                                                                .dump());
    }

    testing::ProgramRun score() const {
        return run_aoscore(std::string(kScored) + " --contestant engine --out page", folder);
    }

    /// The error of the contestant's row, beside which the method's is sound.
    std::string failure() const {
        const auto run = score();
        EXPECT_EQ(run.exit_code, 5) << run.err;
        const Results results = read_results(folder / "page");
        EXPECT_EQ(row_of(results, "alchemy").error, "") << "nothing else is lost";
        EXPECT_EQ(results.rankings.at(0).places.size(), 1U);
        return row_of(results, "engine").error;
    }

    const fs::path folder = output_dir();
    CellRecord method;
};

TEST_F(CommandContestant, ThatCopiesAMethodsImageScoresAsThatMethodDoesToTheBit) {
    describe("cp $1/kept.exr $2");
    const auto run = score();
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    const CellRecord& row = row_of(results, "engine");
    for (const auto& [id, measured] : method.ranked) EXPECT_EQ(row.ranked.at(id).value, measured.value) << id;
    EXPECT_EQ(results.rankings.at(0).places.size(), 2U) << "ranked among the methods";
    EXPECT_FALSE(row.ao.median_ms) << "it reports no cost";
    EXPECT_FALSE(row.parameters.contains("reported_ms"));
    EXPECT_THAT(read_file(folder / "page/index.html"), HasSubstr("My engine"));
}

TEST_F(CommandContestant, IsHandedTheSceneTheViewAndItsParameters) {
    describe(
        "cp $1/kept.exr $2; cp $3 $1/request-$4.json; cp ${3%/*}/scene.glb ${3%/*}/gbuffer.exr $1",
        {{"needs", {"scene", "gbuffer"}}, {"presets", {{"fine", {{"samples", 12}, {"denoise", true}}}}}});
    ASSERT_EQ(score().exit_code, 0);
    const Results results = read_results(folder / "page");
    const ViewRecord& view = results.views[0];
    const auto request =
        nlohmann::json::parse(read_file(folder / fmt::format("engine/request-{}.json", view.radius_m)));
    EXPECT_EQ(request.at("width"), 64);
    EXPECT_EQ(request.at("height"), 48);
    EXPECT_EQ(request.at("view"), "oblique");
    EXPECT_EQ(request.at("radius_m"), view.radius_m);
    EXPECT_EQ(request.at("parameters"), nlohmann::json({{"samples", 12}, {"denoise", true}}));
    EXPECT_EQ(row_of(results, "engine", "fine").parameters.at("samples"), 12);
    const nlohmann::json& camera = request.at("camera");
    EXPECT_NEAR(camera.at("fovy_deg").get<double>(), view.fovy_deg, 1e-9);
    EXPECT_EQ(camera.at("position_m").get<std::vector<double>>(), view.position_m);
    // The camera's own place is the origin of its space.
    const auto matrix = camera.at("world_to_camera").get<std::vector<double>>();
    for (std::size_t row = 0; row < 3; ++row) {
        double sum = matrix[4 * row + 3];
        for (std::size_t axis = 0; axis < 3; ++axis) sum += matrix[4 * row + axis] * view.position_m[axis];
        EXPECT_NEAR(sum, 0, 1e-9);
    }
    // What it is handed is drawn as the view is.
    const auto drawn = run_aoscore("gbuffer wall --view oblique --size 64x48 --out own.exr", folder);
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    const ImageFile own = read_image(folder / "own.exr"), handed = read_image(folder / "engine/gbuffer.exr");
    for (const char* channel : {"Z", "N.X", "P.Y", "mask.Y"})
        EXPECT_EQ(handed.channel(channel)->pixels, own.channel(channel)->pixels) << channel;
    const auto list =
        run_aoscore("score engine/scene.glb --methods alchemy --size 16x12 --samples 2 --out glb", folder);
    ASSERT_EQ(list.exit_code, 0) << list.err;
    EXPECT_EQ(read_results(folder / "glb").views[0].triangles, view.triangles);
}

TEST_F(CommandContestant, ReportsItsCostWhichIsKeptWithItsImage) {
    describe(R"(cp $1/kept.exr $2; echo '{"ms": 0.75, "on": "a card"}' > ${3%/*}/cost.json)");
    for (int time = 0; time < 2; ++time) {
        ASSERT_EQ(score().exit_code, 0);
        const CellRecord row = row_of(read_results(folder / "page"), "engine");
        EXPECT_EQ(row.parameters.at("reported_ms"), 0.75);
        EXPECT_EQ(row.parameters.at("reported_on"), "a card");
        EXPECT_FALSE(row.ao.median_ms) << "it stands beside no time that was measured here";
    }
}

TEST_F(CommandContestant, RunsAgainWhenWhatItDependsOnHasChangedAndOnlyThen) {
    const std::string script = "cp $1/kept.exr $2; echo run >> $1/runs";
    const auto runs = [&] { return read_file(folder / "engine/runs").size() / 4; };
    describe(script);
    ASSERT_EQ(score().exit_code, 0);
    EXPECT_THAT(score().err, HasSubstr("all measured before"));
    EXPECT_EQ(runs(), 1U);
    describe(script, {{"version", "2"}});
    ASSERT_EQ(score().exit_code, 0);
    EXPECT_EQ(runs(), 2U) << "another version";
    describe(script + " # edited", {{"version", "2"}});
    ASSERT_EQ(score().exit_code, 0);
    EXPECT_EQ(runs(), 3U) << "a declared file";
    ASSERT_EQ(
        run_aoscore(std::string(kScored) + " --radius 0.7 --contestant engine --out page", folder).exit_code,
        0);
    EXPECT_EQ(runs(), 4U) << "another radius";
}

TEST_F(CommandContestant, ThatFailsIsAFailedRowWithItsReason) {
    describe("echo the engine is not licensed >&2; exit 7");
    EXPECT_THAT(failure(), HasSubstr("ended with 7: the engine is not licensed"));
    describe("true");
    EXPECT_THAT(failure(), HasSubstr("ended well, and wrote no ao.exr"));
    describe("kill -SEGV $$");
    EXPECT_THAT(failure(), HasSubstr("was ended by signal 11"));
    describe("echo text > $2");
    EXPECT_THAT(failure(), HasSubstr("ao.exr"));
    describe("", {{"words", {"no-such-program-anywhere"}}});
    EXPECT_THAT(failure(), HasSubstr("cannot be started"));
    keep(ImageF(32, 48, 1.0F));
    describe("cp $1/kept.exr $2");
    EXPECT_THAT(failure(), HasSubstr("is 32x48 pixels"));
    ImageF holed(64, 48, 0.5F);
    holed.at(32, 24) = std::numeric_limits<float>::quiet_NaN();
    keep(holed);
    describe("cp $1/kept.exr $2");
    EXPECT_THAT(failure(), HasSubstr("1 pixels are NaN or infinite"));
}

TEST_F(CommandContestant, ThatNeverEndsIsEndedWithAllThatItHasStarted) {
    describe("trap '' TERM; sleep 1000 & echo $! > $1/child; wait; wait", {{"timeout_s", 0.5}});
    EXPECT_THAT(failure(), HasSubstr("did not end within 0.5 s"));
    const pid_t child = std::stoi(read_file(folder / "engine/child"));
    // One that has ended may wait for its new parent, and is a zombie until then.
    const std::string state = testing::run_shell(fmt::format("ps -o state= -p {}", child)).text;
    EXPECT_TRUE(state.empty() || state.starts_with("Z")) << "its child still runs: " << state;
}

TEST_F(CommandContestant, IsFoundByItsIdAmongTheUsersOwn) {
    describe("cp $1/kept.exr $2");
    fs::create_directories(folder / "data/aoscore/contestants");
    fs::rename(folder / "engine", folder / "data/aoscore/contestants/engine");
    const std::string home = "env XDG_DATA_HOME=" + (folder / "data").string();
    const auto run = run_aoscore(std::string(kScored) + " --contestant engine --out page", folder, home);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run_aoscore("list contestants", folder, home).out, HasSubstr("My engine"));
    const auto unknown = run_aoscore(std::string(kScored) + " --contestant engin --out page", folder, home);
    EXPECT_EQ(unknown.exit_code, 64);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean engine?"));
}

TEST_F(CommandContestant, ThatIsNotUnderstoodIsRefusedBeforeAnythingIsMeasured) {
    const std::vector<std::pair<nlohmann::json, std::string>> faults = {
        {{{"timeot_s", 3}}, "timeot_s"},
        {{{"words", nlohmann::json::array()}}, "names no program"},
        {{{"words", {"cp", "{ouput}"}}}, "did you mean output?"},
        {{{"files", {"absent.py"}}}, "absent.py is not there"},
        {{{"needs", {"lights"}}}, "lights"},
        {{{"output", "../ao.exr"}}, "a file's name"},
        {{{"timeout_s", 0}}, "timeout_s"},
        {{{"presets", {{"a", 3}}}}, "an object"}};
    for (const auto& [fault, message] : faults) {
        describe("true", fault);
        const auto run = run_aoscore(std::string(kScored) + " --contestant engine --out refused", folder);
        EXPECT_EQ(run.exit_code, 4) << message;
        EXPECT_THAT(run.err, HasSubstr(message));
        EXPECT_FALSE(fs::exists(folder / "refused"));
    }
}

}  // namespace
}  // namespace aoscore
