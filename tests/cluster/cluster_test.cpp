// The same results, whether one process makes them or many do.
#include "core/files.h"
#include "core/hash.h"
#include "image/image_file.h"
#include "results/results.h"
#include "results/stress_results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <map>
#include <span>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::program;
using testing::run_aoscore;
using testing::run_shell;
using testing::ShellRun;
using testing::source_dir;

const std::string kScore =
    "score pillar --methods gtao,hbao,alchemy,ssao --size 96x54 --samples 32 --out out";

/// Everything that was measured, times aside: metrics of cells, and all pixels of truths, G-buffers and
/// pictures.
std::map<std::string, std::string> measured(const fs::path& folder) {
    std::map<std::string, std::string> found;
    const Results results = read_results(folder);
    for (const CellRecord& cell : results.cells) {
        for (const auto& [metric, score] : cell.ranked)
            found[cell.id + " " + metric] = score.value ? fmt::format("{}", *score.value) : "";
        found[cell.id + " failed"] = cell.error;
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".exr") continue;
        const ImageFile file = read_image(entry.path());
        for (std::size_t i = 0; i < file.channels.size(); ++i) {
            const std::string name =
                fs::relative(entry.path(), folder).string() + " " + file.channel_names[i];
            found[name] = Digest().array(std::span(file.channels[i].pixels)).hex();
        }
    }
    return found;
}

/// What one process measures, in a cache of its own.
std::map<std::string, std::string> measured_by_one(const fs::path& folder) {
    fs::create_directories(folder);
    EXPECT_EQ(run_aoscore(kScore, folder).exit_code, 0);
    return measured(folder / "out");
}

TEST(Plan, MadePartByPartInAnyOrderIsTheResultOfOneProcess) {
    const fs::path folder = output_dir(), parts = folder / "parts";
    const auto one = measured_by_one(folder / "one");
    ASSERT_FALSE(one.empty());
    fs::create_directories(parts);
    ASSERT_EQ(run_aoscore("plan --parts 4 --out plan.json " + kScore, parts).exit_code, 0);
    for (const int part : {3, 1, 4, 2, 3, 9}) {
        const auto run = run_aoscore("work plan.json --part " + std::to_string(part), parts);
        EXPECT_EQ(run.exit_code, 0) << part << run.err;
    }
    ASSERT_EQ(run_aoscore(kScore, parts).exit_code, 0);
    EXPECT_EQ(read_results(parts / "out").work.passes, 0u) << "something was left for the last process";
    EXPECT_EQ(read_results(parts / "out").work.rays, 0u);
    EXPECT_EQ(measured(parts / "out"), one);
    ASSERT_EQ(run_aoscore("plan --parts 4 --out again.json " + kScore, parts).exit_code, 0);
    EXPECT_THAT(read_file(parts / "again.json"), HasSubstr("\"parts\": []")) << "everything is in the cache";
}

TEST(Plan, RefusesWhatPartsCannotDecideAndPlansOfAnotherVersion) {
    const fs::path folder = output_dir();
    const auto run = run_aoscore("plan --parts 2 --out plan.json score pillar --methods gtao", folder);
    EXPECT_EQ(run.exit_code, 64);
    EXPECT_THAT(run.err, HasSubstr("--samples"));
    EXPECT_FALSE(fs::exists(folder / "plan.json"));
    write_atomically(folder / "old.json", R"({"aoscore": "0.0.1", "arguments": [], "parts": []})");
    const auto old = run_aoscore("work old.json --part 1", folder);
    EXPECT_EQ(old.exit_code, 4);
    EXPECT_THAT(old.err, HasSubstr("0.0.1"));
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScore, folder).exit_code, 0);
    std::string other = read_file(folder / "plan.json");
    other.replace(other.find("\"jobs\": [") + 9, 0, "\"0123\", ");
    write_atomically(folder / "other.json", other);
    const auto changed = run_aoscore("work other.json --part 1", folder);
    EXPECT_EQ(changed.exit_code, 64);
    EXPECT_THAT(changed.err, ::testing::AllOf(HasSubstr("0123"), HasSubstr("the cache of the plan")));
}

TEST(Plan, FailsWhereItsPartsAreNotKept) {
    const fs::path folder = output_dir();
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScore, folder).exit_code, 0);
    write_atomically(folder / "input_file", "where a folder should be");
    const auto work = run_aoscore("work plan.json --part 1", folder, "env AOSCORE_CACHE=input_file/cache");
    EXPECT_EQ(work.exit_code, 4) << work.err;
    EXPECT_THAT(work.err, HasSubstr("input_file/cache"));
}

TEST(Plan, SaysWhoseTimesCount) {
    const fs::path folder = output_dir();
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScore + " --node-kind farm", folder).exit_code,
              0);
    const auto other = run_aoscore("work plan.json --part 1 --node-kind other", folder);
    EXPECT_EQ(other.exit_code, 64);
    EXPECT_THAT(other.err, ::testing::AllOf(HasSubstr("\"farm\""), HasSubstr("other")));
    EXPECT_EQ(run_aoscore("work plan.json --part 1 --node-kind farm", folder).exit_code, 0);
}

/// A floor and a wall, of two triangles each.
constexpr const char* kCorner = R"(v 0 0 0
v 2 0 0
v 2 0 2
v 0 0 2
v 0 2 0
v 2 2 0
f 1 3 2
f 1 4 3
f 1 2 6
f 1 6 5
)";
const std::string kScoreOfFile =
    "score corner.obj --eye 1,1,3 --target 1,0.3,0 --methods hbao --size 48x32 --samples 4 --unit m --up y "
    "--radius 0.5 --out out";

TEST(Plan, IsWorkedFromAnyFolderOnTheFilesOfItsOwn) {
    const fs::path folder = output_dir(), elsewhere = folder / "elsewhere";
    fs::create_directories(elsewhere);
    write_atomically(folder / "corner.obj", kCorner);
    write_atomically(elsewhere / "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string cache = "env AOSCORE_CACHE=" + (folder / "one-cache").string();
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScoreOfFile, folder, cache).exit_code, 0);
    const auto work = run_aoscore("work ../plan.json --part 1", elsewhere, "env AOSCORE_CACHE=../one-cache");
    EXPECT_EQ(work.exit_code, 0) << work.err;
    ASSERT_EQ(run_aoscore(kScoreOfFile, folder, cache).exit_code, 0);
    EXPECT_EQ(read_results(folder / "out").work.passes, 0u) << "something was left for the command";
}

TEST(Plan, NamesTheFileThatHasChangedSince) {
    const fs::path folder = output_dir();
    write_atomically(folder / "corner.obj", kCorner);
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScoreOfFile, folder).exit_code, 0);
    write_atomically(folder / "corner.obj", std::string(kCorner) + "v 1 1 1\nf 1 2 7\n");
    const auto work = run_aoscore("work plan.json --part 1", folder);
    EXPECT_EQ(work.exit_code, 4) << work.err;
    EXPECT_THAT(work.err,
                ::testing::AllOf(HasSubstr("corner.obj has changed since the jobs were listed"),
                                 ::testing::ContainsRegex("[a-z_]+ of corner/.* \\([0-9a-f]{32}\\)"),
                                 HasSubstr("make the plan again")));
    EXPECT_THAT(work.err, ::testing::Not(HasSubstr("KEY")));
}

/// The floor and two walls of a room of 2 m as a glTF file whose buffer is a file of its own.
void write_room(const fs::path& folder, float height) {
    const std::vector<float> positions = {0, 0, 0, 2, 0, 0, 2, 0, 2, 0, 0, 2, 0, height, 0, 2, height, 0};
    const std::vector<std::uint16_t> triangles = {0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4};
    std::string bytes(reinterpret_cast<const char*>(positions.data()), positions.size() * sizeof(float));
    bytes.append(reinterpret_cast<const char*>(triangles.data()), triangles.size() * sizeof(std::uint16_t));
    write_atomically(folder / "a room.bin", bytes);
    write_atomically(folder / "room.gltf", R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": "a%20room.bin", "byteLength": 96}],
        "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
                       "min": [0, 0, 0], "max": [2, 2, 2]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]})");
}

TEST(Plan, NamesTheSideFileOfAGltfThatHasChangedOrGone) {
    const fs::path folder = output_dir();
    const std::string score =
        "score room.gltf --eye 1,1,3 --target 1,0.3,0 --methods hbao --size 48x32 --samples 4 --radius 0.5 "
        "--out out";
    write_room(folder, 2);
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + score, folder).exit_code, 0);
    write_room(folder, 1.5F);
    const auto changed = run_aoscore("work plan.json --part 1", folder);
    EXPECT_EQ(changed.exit_code, 4) << changed.err;
    EXPECT_THAT(changed.err, ::testing::AllOf(HasSubstr("a room.bin has changed since the jobs were listed"),
                                              HasSubstr("make the plan again")));
    fs::remove(folder / "a room.bin");
    const auto gone = run_aoscore("work plan.json --part 1", folder);
    EXPECT_EQ(gone.exit_code, 4) << gone.err;
    EXPECT_THAT(gone.err, HasSubstr("a room.bin has changed since the jobs were listed"));
    write_room(folder, 2);
    const auto restored = run_aoscore("work plan.json --part 1", folder);
    EXPECT_EQ(restored.exit_code, 0) << restored.err;
}

TEST(Plan, LeavesOutTheMarkOfTheCommandThatItDividesAndNoOther) {
    const fs::path folder = output_dir();
    const auto marked = run_aoscore("--seed 1 plan --parts 1 --out marked.json -- " + kScore, folder);
    EXPECT_EQ(marked.exit_code, 0) << marked.err;
    // Behind the mark a word is no option, also where the scene is a file named plan.
    const auto scene = run_aoscore("score plan -- --methods", folder);
    EXPECT_EQ(scene.exit_code, 64) << scene.err;
    EXPECT_THAT(scene.err, ::testing::Not(HasSubstr("--methods requires")));
}

TEST(Plan, IsTheSameWithAMarkBeforeTheCommandAndItsHelpShowsOne) {
    const fs::path folder = output_dir();
    ASSERT_EQ(run_aoscore("plan --parts 2 --out plain.json " + kScore, folder).exit_code, 0);
    const auto marked = run_aoscore("plan --parts 2 --out marked.json -- " + kScore, folder);
    ASSERT_EQ(marked.exit_code, 0) << marked.err;
    EXPECT_EQ(read_file(folder / "marked.json"), read_file(folder / "plain.json"));
    EXPECT_THAT(run_aoscore("plan --help", folder).out,
                HasSubstr("aoscore plan --parts 8 --out plan.json score atrium"));
}

TEST(Plan, LeavesNoOptionOfAPartUnheeded) {
    const fs::path folder = output_dir();
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + kScore, folder).exit_code, 0);
    for (const char* option : {"--seed 2", "--threads 1", "--threads=1", "--gl osmesa"}) {
        const auto work = run_aoscore(std::string("work plan.json --part 1 ") + option, folder);
        EXPECT_EQ(work.exit_code, 64) << option;
        EXPECT_THAT(work.err, HasSubstr("plan the command with it")) << option;
    }
    const auto quiet = run_aoscore("work plan.json --part 1 --quiet", folder);
    EXPECT_EQ(quiet.exit_code, 0);
    EXPECT_EQ(quiet.err, "");
}

/// How often each cell's AO pass was timed and shown, by cell.
std::map<std::string, std::vector<double>> times_in(const fs::path& folder) {
    std::map<std::string, std::vector<double>> times;
    for (const CellRecord& cell : read_results(folder).cells) {
        EXPECT_EQ(cell.error, "");
        times[cell.id] = cell.ao.runs_ms;
    }
    return times;
}

// Two processes, each on a node of another kind; only one of the kinds has a clock that counts.
TEST(Times, AreTakenOnNodesOfTheNamedKindAlone) {
    const fs::path folder = output_dir();
    const std::string quick =
                          "score pillar --view main --methods gtao,ssao --size 96x54 --samples 4 --out out",
                      named = quick + " --node-kind timing", timing = "env AOSCORE_NODE_KIND=timing",
                      other = "env AOSCORE_NODE_KIND=other";
    const auto plan = run_aoscore("plan --parts 1 --out plan.json " + named, folder, other);
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_THAT(plan.err, HasSubstr("Times are taken on nodes of kind \"timing\" alone"));
    EXPECT_THAT(read_file(folder / "plan.json"), HasSubstr(R"("times_on": "timing")"));

    const auto work = run_aoscore("work plan.json --part 1", folder, other);
    EXPECT_EQ(work.exit_code, 0) << work.err;
    EXPECT_THAT(work.err,
                ::testing::AllOf(HasSubstr("left out"), HasSubstr("\"timing\""), HasSubstr("\"other\"")));
    ASSERT_EQ(run_aoscore(named, folder, other).exit_code, 0);
    for (const auto& [cell, runs] : times_in(folder / "out")) EXPECT_TRUE(runs.empty()) << cell;
    Results results = read_results(folder / "out");
    EXPECT_EQ(results.work.passes, 0u) << "all but the times was there";
    EXPECT_THAT(results.views.at(0).warnings, ::testing::Contains(HasSubstr("left out")));

    // Planned again, the times alone are left, and their part is one for a node of that kind.
    ASSERT_EQ(run_aoscore("plan --parts 1 --out rest.json " + named, folder, other).exit_code, 0);
    const auto rest = nlohmann::json::parse(read_file(folder / "rest.json")).at("parts");
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_EQ(rest.at(0).at("jobs").size(), 3U) << "of two cells and of the G-buffer";
    ASSERT_EQ(run_aoscore("work rest.json --part 1", folder, timing).exit_code, 0);
    ASSERT_EQ(run_aoscore(named, folder, other).exit_code, 0);
    const auto shown = times_in(folder / "out");
    results = read_results(folder / "out");
    for (const auto& [cell, runs] : shown) EXPECT_FALSE(runs.empty()) << cell;
    EXPECT_EQ(results.work.passes, 0u);
    EXPECT_THAT(results.cpu, HasSubstr("times: nodes of kind \"timing\""));
    EXPECT_THAT(results.views.at(0).warnings, ::testing::Not(::testing::Contains(HasSubstr("left out"))));
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("nodes of kind"));
    // On the kind of node that took them they are the same ones; one of another kind takes its own.
    ASSERT_EQ(run_aoscore(quick, folder, timing).exit_code, 0);
    EXPECT_EQ(times_in(folder / "out"), shown);
    ASSERT_EQ(run_aoscore(quick, folder, other).exit_code, 0);
    EXPECT_NE(times_in(folder / "out"), shown);
}

// What a plan divides it names the kind for: a node of another kind knows its jobs, and takes no times.
TEST(Times, OfAPlanWithoutANamedKindAreThoseOfThePlanningNode) {
    const fs::path folder = output_dir();
    const std::string quick = "score pillar --view main --methods ssao --size 64x36 --samples 4 --out out";
    ASSERT_EQ(
        run_aoscore("plan --parts 1 --out plan.json " + quick, folder, "env AOSCORE_NODE_KIND=a").exit_code,
        0);
    const auto work = run_aoscore("work plan.json --part 1", folder, "env AOSCORE_NODE_KIND=b");
    EXPECT_EQ(work.exit_code, 0) << work.err;
    EXPECT_THAT(work.err, HasSubstr("left out"));
    const auto refused = run_aoscore(
        "tune pillar --methods gtao --parameters steps --budget-ms 100 --size 64x36 --samples 4 --node-kind "
        "a",
        folder, "env AOSCORE_NODE_KIND=b");
    EXPECT_EQ(refused.exit_code, 64);
    EXPECT_THAT(refused.err, HasSubstr("--budget-ms takes times"));
    EXPECT_EQ(run_aoscore(quick + " --node-kind ''", folder).exit_code, 64);
}

/// Cells of a stress test by subject and setting: what is wrong with each, and whether it was timed.
std::map<std::string, std::pair<std::string, bool>> stressed_in(const fs::path& folder) {
    std::map<std::string, std::pair<std::string, bool>> cells;
    for (const StressAxisRecord& axis : read_stress_results(folder).axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            for (const StressCell& cell : setting.cells)
                cells[cell.subject + " " + setting.id] = {cell.error + cell.breaks, cell.time_ms.has_value()};
        }
    }
    return cells;
}

TEST(Times, OfAStressTestAreLeftOutWithoutAFault) {
    const fs::path folder = output_dir();
    const std::string quick = "stress --quick --methods gtao --axes radius --out out",
                      named = quick + " --node-kind timing", timing = "env AOSCORE_NODE_KIND=timing";
    const auto run = run_aoscore(named, folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, ::testing::AllOf(HasSubstr("left out"), HasSubstr("\"timing\"")));
    const auto untimed = stressed_in(folder / "out");
    for (const auto& [cell, state] : untimed) EXPECT_FALSE(state.second) << cell;

    // A part of its plan leaves them out too, and a node of the kind takes them.
    ASSERT_EQ(run_aoscore("plan --parts 1 --out plan.json " + named, folder).exit_code, 0);
    EXPECT_EQ(run_aoscore("work plan.json --part 1", folder).exit_code, 0);
    ASSERT_EQ(run_aoscore("work plan.json --part 1", folder, timing).exit_code, 0);
    ASSERT_EQ(run_aoscore(named, folder).exit_code, 0);
    const auto timed = stressed_in(folder / "out");
    ASSERT_EQ(timed.size(), untimed.size());
    EXPECT_TRUE(timed.at("gtao " + read_stress_results(folder / "out").axes.at(0).settings.at(0).id).second);
    for (const auto& [cell, state] : timed) EXPECT_EQ(state.first, untimed.at(cell).first) << cell;
}

TEST(Times, ThatAreMissingChooseNoSettingOfASweepAndJudgeNoClaim) {
    const fs::path folder = output_dir();
    const std::string sweep =
        "sweep wall --view facing --methods sao --vary samples=4,8 --size 48x32 --samples 4 --out out"
        " --node-kind timing";
    const auto refused = run_aoscore(sweep + " --budget-ms 50", folder);
    EXPECT_EQ(refused.exit_code, 64);
    EXPECT_THAT(refused.err, HasSubstr("--budget-ms takes times"));
    ASSERT_EQ(run_aoscore(sweep, folder).exit_code, 0);
    EXPECT_THAT(read_file(folder / "out/index.html"),
                ::testing::AllOf(HasSubstr("Errors were measured and no times"), HasSubstr("left out"),
                                 ::testing::Not(HasSubstr("Nothing could be measured"))));
    // Where they are kept, the budget chooses by them.
    ASSERT_EQ(run_aoscore(sweep, folder, "env AOSCORE_NODE_KIND=timing").exit_code, 0);
    EXPECT_EQ(run_aoscore(sweep + " --budget-ms 50", folder).exit_code, 0);

    ASSERT_EQ(run_aoscore("claims H06 --scale 0.05 --out claims --node-kind timing", folder).exit_code, 0);
    const Results claims = read_results(folder / "claims");
    ASSERT_EQ(claims.claims.size(), 1U);
    EXPECT_EQ(claims.claims[0].verdict, ClaimRecord::kCannotTell);
    EXPECT_THAT(claims.claims[0].reason, HasSubstr("times are taken on nodes of kind \"timing\""));
}

TEST(Snakemake, MakesTheResultOfOneProcess) {
    const fs::path folder = output_dir(), many = folder / "many";
    const auto one = measured_by_one(folder / "one");
    fs::create_directories(many);
    const ShellRun ended = run_shell(
        "cd '" + many.string() + "' && HOME='" + many.string() + "' AOSCORE_CACHE='" +
        (many / "truth-cache").string() + "' snakemake -s '" + (source_dir() / "cluster/Snakefile").string() +
        "' --cores 2 --config parts=4 aoscore='" + program() + "' command='" + kScore + "'");
    ASSERT_EQ(ended.status, 0) << ended.text;
    EXPECT_EQ(measured(many / "out"), one);
}

/// A Slurm of one node on this machine, for as long as it lives.
class LocalSlurm {
  public:
    explicit LocalSlurm(fs::path folder) : folder_(std::move(folder)) {
        started_ = run_shell(script("start"));
    }
    /// How its daemons came up; a container may not let them.
    const ShellRun& started() const { return started_; }
    ~LocalSlurm() { run_shell(script("stop")); }
    ShellRun run(const std::string& command) const {
        return run_shell("export SLURM_CONF='" + (folder_ / "slurm.conf").string() + "'; " + command);
    }

  private:
    std::string script(const std::string& what) const {
        return "bash '" + (source_dir() / "tests/cluster/local_slurm.sh").string() + "' " + what + " '" +
               folder_.string() + "'";
    }
    fs::path folder_;
    ShellRun started_;
};

TEST(Slurm, MakesTheResultOfOneProcessWithAPartKilledAndRequeued) {
    const fs::path folder = output_dir(), many = folder / "many";
    const auto one = measured_by_one(folder / "one");
    fs::create_directories(many);
    const LocalSlurm slurm(folder / "slurm");
    if (slurm.started().status != 0)
        GTEST_SKIP() << "Slurm does not start on this machine: " << slurm.started().text;
    const std::string here = "cd '" + many.string() + "' && export AOSCORE_CACHE='" +
                             (many / "truth-cache").string() + "' AOSCORE='" + program() + "'; ";
    const ShellRun ended = slurm.run(here + "page=$('" + (source_dir() / "cluster/slurm.sh").string() +
                                     "' 8 " + kScore + R"() || exit 1
array=$(squeue -h -r -o '%F %j' | awk '$2 == "aoscore-part" { print $1; exit }')
for _ in $(seq 100); do squeue -h -r -t RUNNING -o '%j' | grep -q aoscore-part && break; sleep 0.05; done
part=$(squeue -h -r -t RUNNING -o '%K %j' | awk '$2 == "aoscore-part" { print $1; exit }')
echo "requeued part $part"
scontrol requeue "${array}_$part"
for _ in $(seq 1200); do
    state=$(scontrol show job "$page" | sed -n 's/.*JobState=\([A-Z]*\).*/\1/p')
    case $state in COMPLETED) exit 0 ;; FAILED | CANCELLED | TIMEOUT) break ;; esac
    sleep 0.1
done
squeue; scontrol show job "$page"; tail work/*.log; exit 1)");
    ASSERT_EQ(ended.status, 0) << ended.text;
    EXPECT_THAT(ended.text, ::testing::ContainsRegex("requeued part [1-8]"));
    EXPECT_EQ(measured(many / "out"), one);
}

}  // namespace
}  // namespace aoscore
