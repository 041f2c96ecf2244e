// Tests the outcomes of runs: limits, exit codes, exports in every format, baselines.
#include "core/files.h"
#include "image/image_file.h"
#include "results/export/export_format.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <fstream>
#include <map>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

constexpr const char* kScore = "score wall --view facing --size 64x48 --samples 16 --methods alchemy,hbao ";

void write_pair(const std::filesystem::path& folder, float standard_error = 0) {
    ImageF truth(64, 48, 0.5F), test(64, 48, 0.5F), error(64, 48, standard_error);
    for (std::size_t i = 0; i < test.size(); ++i) test.pixels[i] += i % 3 == 0 ? 0.2F : 0.0F;
    std::vector<ChannelView> channels{{"Y", &truth}};
    if (standard_error > 0) channels.push_back({"SE.Y", &error});
    write_exr(folder / "truth.exr", channels, {});
    write_exr(folder / "test.exr", std::vector<ChannelView>{{"Y", &test}}, {});
}

TEST(Limits, AFailedOneNamesAThresholdThatPasses) {
    const auto folder = output_dir();
    write_pair(folder);
    const ProgramRun failed = run_aoscore("compare truth.exr test.exr --fail 'rmse>0.02'", folder);
    EXPECT_EQ(failed.exit_code, 2);
    const auto end = failed.err.find(" would have passed");
    ASSERT_NE(end, std::string::npos) << failed.err;
    const auto begin = failed.err.rfind("; ", end) + 2;
    const std::string passing = failed.err.substr(begin, end - begin);
    EXPECT_THAT(passing, ::testing::StartsWith("rmse>0.1"));
    EXPECT_EQ(run_aoscore("compare truth.exr test.exr --fail '" + passing + "'", folder).exit_code, 0);
}

TEST(Limits, BelowTheNoiseOfTheTruthAreRefused) {
    const auto folder = output_dir();
    write_pair(folder, 0.05F);
    const ProgramRun run = run_aoscore("compare truth.exr test.exr --fail 'rmse>0.04'", folder);
    EXPECT_EQ(run.exit_code, 64);
    EXPECT_THAT(run.err, HasSubstr("below the noise of the truth, 0.05"));
    EXPECT_EQ(run_aoscore("compare truth.exr test.exr --fail 'rmse>0.2'", folder).exit_code, 0);
}

TEST(Limits, MayHaveBlanksAndBeOnMaskAreas) {
    const auto folder = output_dir();
    write_pair(folder);  // a third of the pixels is brighter by 0.2
    EXPECT_EQ(run_aoscore("compare truth.exr test.exr --fail 'rmse > 0.2' --fail ' missing_area >= 0.34 '"
                          " --fail 'false_area>0'",
                          folder)
                  .exit_code,
              0);
    const ProgramRun failed = run_aoscore("compare truth.exr test.exr --fail 'missing_area > 0.3'", folder);
    EXPECT_EQ(failed.exit_code, 2);
    EXPECT_THAT(failed.err, HasSubstr("missing_area is 0.333"));
}

TEST(Limits, SeveralThatWereTrippedAreCountedInOneLine) {
    const auto folder = output_dir();
    write_pair(folder);
    const ProgramRun two =
        run_aoscore("compare truth.exr test.exr --fail 'rmse>0' --fail 'mae>0' --warn 'ssim<1'", folder);
    EXPECT_THAT(two.err, ::testing::EndsWith("2 limits of --fail and 1 of --warn tripped\n"));
    const ProgramRun cells = run_aoscore(std::string(kScore) + "--out o --fail 'missing_area>=0'", folder);
    EXPECT_EQ(cells.exit_code, 2);
    EXPECT_THAT(cells.err, HasSubstr("tripped in "));
    EXPECT_THAT(run_aoscore("compare truth.exr test.exr --fail 'rmse>0'", folder).err,
                ::testing::Not(HasSubstr("limits of")));
}

TEST(Limits, DecideTheExitCodeOfAScoreCellByCell) {
    const auto folder = output_dir();
    const ProgramRun failed = run_aoscore(std::string(kScore) + "--out o --fail 'ssim<0.999999'", folder);
    EXPECT_EQ(failed.exit_code, 2) << failed.err;
    EXPECT_THAT(failed.err, HasSubstr("fail wall/facing/alchemy/default: ssim<0.999999: ssim is "));
    EXPECT_EQ(failed.out, "o/index.html\n") << "the page is there all the same";
    EXPECT_EQ(run_aoscore("page o --warn 'ssim<0.999999'", folder).exit_code, 1);
    EXPECT_EQ(run_aoscore("page o/results.json --fail 'ssim<-1'", folder).exit_code, 0);
}

// A claim that nothing here can tell scores nothing, which is no fault; a limit on nothing is one.
TEST(Limits, AreNotPassedWhereNothingWasScored) {
    const auto folder = output_dir();
    EXPECT_EQ(run_aoscore("claims F03 --out o", folder).exit_code, 0);
    for (const char* arguments :
         {"claims F03 --out o --fail 'rmse>0.9'", "page o --warn 'rmse>0.9' --export a.xml"}) {
        const ProgramRun run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 2) << arguments << run.err;
        EXPECT_THAT(run.err, HasSubstr("no method was scored: nothing could be compared")) << arguments;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.xml"));
}

TEST(Exports, EveryFormatHoldsTheNumbersOfACompare) {
    const auto folder = output_dir();
    write_pair(folder);
    std::string arguments = "compare truth.exr test.exr --fail 'rmse>0.02'";
    for (const ExportFormat& format : export_formats())
        arguments += " --export out" + std::string(format.extension);
    EXPECT_EQ(run_aoscore(arguments, folder).exit_code, 2);
    for (const ExportFormat& format : export_formats()) {
        const std::string text = read_file(folder / ("out" + std::string(format.extension)));
        EXPECT_THAT(text, HasSubstr("0.115")) << format.label << ": the RMSE is sqrt(0.2^2 / 3)";
        EXPECT_THAT(text, HasSubstr("test.exr")) << format.label;
    }
}

TEST(Exports, OfAScoreHaveARowForEachCellAndJUnitTheTrippedLimits) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore(std::string(kScore) + "--out o", folder).exit_code, 0);
    EXPECT_EQ(
        run_aoscore("page o --fail 'ssim<0.999999' --export a.csv --export a.xml --export a.tex", folder)
            .exit_code,
        2);
    const Results results = read_results(folder / "o");
    const std::string csv = read_file(folder / "a.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(results.cells.size()) + 1);
    EXPECT_THAT(csv, HasSubstr(",radius_m,radius_px,radius_rule,lengths,error\r\n"));
    EXPECT_THAT(read_file(folder / "a.tex"), HasSubstr("\\toprule"));
    EXPECT_THAT(read_file(folder / "a.tex"), HasSubstr("pixels in the median"));
    pugi::xml_document xml;
    ASSERT_TRUE(xml.load_file((folder / "a.xml").c_str()));
    const pugi::xml_node suite = xml.child("testsuites").child("testsuite");
    EXPECT_EQ(suite.attribute("tests").as_uint(), results.cells.size());
    EXPECT_EQ(suite.attribute("failures").as_uint(), results.cells.size());
    std::size_t i = 0;
    for (const pugi::xml_node test : suite.children("testcase")) {
        const CellRecord& cell = results.cells.at(i++);
        const pugi::xml_node rmse =
            test.child("properties").find_child_by_attribute("property", "name", "rmse");
        EXPECT_EQ(rmse.attribute("value").as_double(), *cell.ranked.at("rmse").value) << cell.id;
        EXPECT_THAT(test.child("failure").attribute("message").value(), HasSubstr("ssim is"));
        EXPECT_EQ(cell.view_key + "/" + test.attribute("name").value(), cell.id);
    }
}

void write_bound(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "method.json") << R"({"label": "My limit", "role": "bound", "paper": "-",
        "summary": "-", "passes": [{"fragment": "ao.frag", "inputs": ["linear_depth"]}]})";
    std::ofstream(folder / "ao.frag")
        << "#include \"contract/ao_pass.glsl\"\n"
           "float visibility(vec2 image_px, vec3 position) { return min(1.0, centre_linear_depth()); }\n";
}

TEST(Exports, SayOfABoundThatItIsOne) {
    const auto folder = output_dir();
    write_bound(folder / "mine/my-bound");
    const std::map<std::string, std::string> marks{{".csv", "wall/facing,bound,my-bound,bound,default"},
                                                   {".json", "\"method_label\": \"My limit (bound)\""},
                                                   {".md", "| wall/facing | bound | my-bound | default |"},
                                                   {".tex", "wall/facing & bound & my-bound & default"},
                                                   {".xml", "<property name=\"role\" value=\"bound\""}};
    std::string arguments =
        "score wall --view facing --size 64x48 --samples 16 --methods alchemy,my-bound --methods-dir mine "
        "--out o";
    for (const ExportFormat& format : export_formats())
        arguments += " --export out" + std::string(format.extension);
    const ProgramRun run = run_aoscore(arguments, folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const ExportFormat& format : export_formats()) {
        const std::string extension(format.extension);
        ASSERT_TRUE(marks.contains(extension)) << "how does " << extension << " mark a bound?";
        EXPECT_THAT(read_file(folder / ("out" + extension)), HasSubstr(marks.at(extension))) << extension;
    }
    EXPECT_THAT(read_file(folder / "out.csv"), HasSubstr("wall/facing,1,alchemy,method,default"))
        << "what a bound reaches takes no rank away";
    const std::string page = read_file(folder / "o/index.html");
    EXPECT_THAT(page, HasSubstr("Alchemy AO is the only method scored"));
    EXPECT_THAT(page, HasSubstr("My limit (bound)"));
}

TEST(Exports, AWrongPathFailsBeforeTheWorkBegins) {
    const auto folder = output_dir();
    EXPECT_EQ(run_aoscore(std::string(kScore) + "--out o --export nowhere/a.csv", folder).exit_code, 4);
    const ProgramRun unknown =
        run_aoscore(std::string(kScore) + "--out o --export a.csv --export a.doc", folder);
    EXPECT_EQ(unknown.exit_code, 64);
    EXPECT_THAT(unknown.err, HasSubstr(".csv, .json, .md, .tex, .xml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "o"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST(Baseline, TheSameRunIsTheSameAndAWorseOneFailsWhereAskedTo) {
    const auto folder = output_dir();
    ASSERT_EQ(run_aoscore(std::string(kScore) + "--out first", folder).exit_code, 0);
    const ProgramRun again =
        run_aoscore(std::string(kScore) + "--out again --baseline first/results.json --fail worse", folder);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    const Results results = read_results(folder / "again");
    ASSERT_TRUE(results.baseline);
    ASSERT_EQ(results.baseline->changes.size(), results.cells.size());
    for (const ChangeRecord& change : results.baseline->changes) {
        EXPECT_EQ(change.verdict, "same") << change.cell_id << " " << change.reason;
        EXPECT_EQ(change.before, change.now) << change.cell_id;
    }
    // With a radius of a millimetre it finds no occlusion at all.
    const ProgramRun worse = run_aoscore(
        "score wall --view facing --size 64x48 --samples 16 --methods alchemy --set radius=0.001 --out worse "
        "--baseline "
        "first --fail worse",
        folder);
    EXPECT_EQ(worse.exit_code, 2) << worse.err;
    EXPECT_THAT(worse.err, HasSubstr("95 % confidence"));
    const ProgramRun untold = run_aoscore(
        "score wall --view facing --size 32x24 --samples 16 --methods alchemy --out other --baseline first "
        "--fail worse",
        folder);
    EXPECT_EQ(untold.exit_code, 2) << untold.err;
    EXPECT_THAT(untold.err, HasSubstr("cannot be told: the images differ in size"));
    EXPECT_EQ(run_aoscore(std::string(kScore) + "--out o --fail worse", folder).exit_code, 64)
        << "worse than what?";
}

}  // namespace
}  // namespace aoscore
