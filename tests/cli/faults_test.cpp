// Tests faults around the program: streams, caches, names and signals.
#include "core/files.h"
#include "core/folders.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

constexpr const char* kScore = "score wall --view facing --size 64x48 --samples 4 --methods alchemy --out o ";

/// One triangle, as a glTF file of that name.
void write_scene(const fs::path& path) {
    std::ofstream(path)
        << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]})";
}

std::string line_with(const std::string& text, const std::string& part) {
    const std::size_t at = text.find(part);
    if (at == std::string::npos) return {};
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

TEST(StandardOutput, ThatCannotBeWrittenIsAnErrorThatSaysSo) {
    const auto folder = output_dir();
    for (const char* arguments : {"list metrics", "list methods", "--help", "--version", "cache list"}) {
        const ProgramRun full = run_aoscore(arguments, folder, R"(sh -c '"$@" >/dev/full' sh)");
        EXPECT_EQ(full.exit_code, 4) << arguments;
        EXPECT_THAT(full.err, HasSubstr("standard output: cannot be written: No space left on device"))
            << arguments;
        EXPECT_EQ(run_aoscore(arguments, folder, R"(sh -c '"$@" >&-' sh)").exit_code, 4) << arguments;
    }
}

// Mesa says so of any driver of its own when it is asked to.
TEST(OpenGl, OfALesserVersionEndsWithAnInternalErrorThatNamesTheVersionNeeded) {
    const auto folder = output_dir();
    for (const std::string gl : {"osmesa", "egl:software"}) {
        const ProgramRun run = run_aoscore("gbuffer wall --size 16x16 --out g.exr --gl " + gl, folder,
                                           "env MESA_GL_VERSION_OVERRIDE=3.2");
        EXPECT_EQ(run.exit_code, 70) << gl;
        EXPECT_THAT(run.err, HasSubstr("OpenGL 3.3 core")) << gl;
        EXPECT_FALSE(fs::exists(folder / "g.exr")) << gl;
    }
}

TEST(StandardOutput, ThatIsClosedNeverEndsUpInAFile) {
    const auto folder = output_dir();
    run_aoscore("gbuffer wall --size 16x16 --out g.exr", folder, R"(sh -c '"$@" >&- 2>&-' sh)");
    EXPECT_EQ(run_aoscore("compare g.exr g.exr --channel Z --truth-channel Z", folder).exit_code, 0);
}

TEST(StandardError, ThatCannotBeWrittenEndsNoRun) {
    EXPECT_EQ(
        run_aoscore("gbuffer wall --size 16x16 --out g.exr", output_dir(), R"(sh -c '"$@" 2>/dev/full' sh)")
            .exit_code,
        0);
}

TEST(UnwritableCache, IsSaidAndTheWorkGoesOn) {
    const auto folder = output_dir();
    std::ofstream(folder / "input_file") << "where a folder should be";
    const std::string prefix = "env AOSCORE_CACHE='" + (folder / "input_file/cache").string() + "'";
    const ProgramRun score = run_aoscore(kScore, folder, prefix);
    EXPECT_EQ(score.exit_code, 0) << score.err;
    EXPECT_THAT(score.err, HasSubstr("warning: measurements are not kept: "));
    EXPECT_THAT(score.err, HasSubstr("warning: the truth is not kept: "));
    const std::size_t first = score.err.find("measurements are not kept");
    EXPECT_EQ(score.err.find("measurements are not kept", first + 1), std::string::npos) << "once is enough";
    EXPECT_EQ(read_results(folder / "o").cells.size(), 1U);
    const ProgramRun reference =
        run_aoscore("reference wall --size 16x16 --samples 4 --out t.exr", folder, prefix);
    EXPECT_EQ(reference.exit_code, 0) << reference.err;
}

TEST(UnwritableCache, AFolderInPlaceOfAFileIsNoDamageOf2To64Bytes) {
    const auto folder = output_dir();
    const std::string reference = "reference wall --size 16x16 --samples 4 --out t.exr";
    ASSERT_EQ(run_aoscore(reference, folder).exit_code, 0);
    fs::path truth;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "truth-cache"))
        if (entry.path().extension() == ".truth") truth = entry.path();
    const auto put_folder = [&] {
        fs::remove(truth);
        fs::create_directories(truth / "inner");
    };
    put_folder();
    for (const char* command : {"cache list", "cache verify"}) {
        const ProgramRun run = run_aoscore(command, folder);
        EXPECT_THAT(run.out, HasSubstr("unreadable")) << command;
        EXPECT_THAT(run.out, Not(HasSubstr("18446744073709551615"))) << command;
    }
    EXPECT_EQ(run_aoscore(reference, folder).exit_code, 0);
    EXPECT_THAT(run_aoscore(reference, folder).err, HasSubstr("from the cache"))
        << "a file has taken its place";
    put_folder();
    EXPECT_EQ(run_aoscore("cache clear", folder).exit_code, 0);
    EXPECT_FALSE(fs::exists(truth));
}

TEST(SceneName, OfAnyBytesIsScoredAndShownWithoutHarm) {
    const auto folder = output_dir();
    // A byte that is no UTF-8, a mark that changes the direction of text, a line separator, a line break.
    const std::string name = "sc\xFF\u202E\u2028\nene";
    write_scene(folder / (name + ".gltf"));
    const std::string quoted = "'" + name + ".gltf'";
    const ProgramRun run =
        run_aoscore("score " + quoted + " --size 32x32 --samples 4 --methods alchemy --out o", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string shown = "sc\uFFFD\uFFFD\uFFFD\uFFFDene";
    EXPECT_EQ(read_results(folder / "o").views.at(0).scene, shown);
    EXPECT_THAT(run.err, HasSubstr(shown));
    const ProgramRun reference =
        run_aoscore("reference " + quoted + " --size 16x16 --samples 4 --out t.exr", folder);
    EXPECT_EQ(reference.exit_code, 0) << reference.err;
    const ProgramRun list = run_aoscore("cache list", folder);
    for (const std::string& text : {run.err, list.out, read_file(folder / "o" / "index.html")}) {
        for (const char* bad : {"\xFF", "\u202E", "\u2028"}) EXPECT_THAT(text, Not(HasSubstr(bad)));
    }
    // The stored command is one line that a shell accepts.
    const std::string command = line_with(read_file(folder / "o" / "results.json"), "\"command\"");
    EXPECT_THAT(command, HasSubstr("$'sc\\\\377\\\\342\\\\200\\\\256"));
}

TEST(MethodFolder, ThatIsBadIsNamedInAWarningAndTheOthersAreListedAndScored) {
    const auto folder = output_dir();
    fs::create_directories(folder / "mine" / "bad");
    std::ofstream(folder / "mine" / "bad" / "method.json") << R"({"label": 1e999})";
    fs::copy(data_dir() / "shaders" / "methods" / "alchemy", folder / "mine" / "good",
             fs::copy_options::recursive);
    const ProgramRun list = run_aoscore("list methods --methods-dir mine", folder);
    EXPECT_EQ(list.exit_code, 0) << list.err;
    EXPECT_THAT(list.out, HasSubstr("good "));
    EXPECT_THAT(list.err, HasSubstr("warning: method bad is left out: mine/bad/method.json: line 1"));
    const std::string score =
        "score wall --view facing --size 32x32 --samples 4 --out o --methods-dir mine --methods ";
    const ProgramRun good = run_aoscore(score + "good", folder);
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_THAT(good.err, HasSubstr("method bad is left out"));
    const ProgramRun bad = run_aoscore(score + "good,bad", folder);
    EXPECT_EQ(bad.exit_code, 4);
    EXPECT_THAT(bad.err, HasSubstr("mine/bad/method.json: line 1"));
}

TEST(ResultsFile, WithANumberThatNoDoubleHoldsExitsWith4) {
    const auto folder = output_dir();
    std::ofstream(folder / "results.json") << R"({"schema_version": 1e999})";
    const ProgramRun run = run_aoscore("page results.json", folder);
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_THAT(run.err, HasSubstr("results.json: line 1, column"));
}

// The rasteriser crashes where it gets no memory.
TEST(Memory, ThatALimitLeavesTooLittleOfIsTheWordOfTheError) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "a sanitizer's address space has no limit";
#endif
    for (const char* command : {"gbuffer wall --size 16x16 --out g.exr --threads 64",
                                "score wall --view facing --size 16x16 --samples 4 --methods alchemy --out o "
                                "--threads 64"}) {
        const ProgramRun run =
            run_aoscore(command, output_dir(), R"(sh -c 'ulimit -v 2000000; exec "$@"' sh)");
        EXPECT_EQ(run.exit_code, 70) << command << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr("memory")) << command;
    }
}

// As `timeout -s INT` does, it sends one signal to the process and one to its group.
TEST(Interrupts, TwoInQuickSuccessionAreOne) {
    const auto folder = output_dir();
    const ProgramRun run = run_aoscore("score sphere --samples 100000 --out o", folder,
                                       R"(sh -c '"$@" & sleep 3; kill -INT $!; kill -INT $!; wait $!' sh)");
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("interrupted"));
    EXPECT_FALSE(fs::exists(folder / "o")) << "a stopped run must leave nothing";
}

}  // namespace
}  // namespace aoscore
