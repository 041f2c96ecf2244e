// The contestants of contestants/: three.js and N8AO in Chromium, Cycles in Blender. Where their program is
// not installed they are skipped, but for Chromium, which the tests' set-up brings.
#include "core/files.h"
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <set>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kView = "atrium --view wide --size 96x54";

std::vector<std::string> shipped() {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(testing::source_dir() / "contestants")) {
        if (fs::exists(entry.path() / "contestant.json")) ids.push_back(entry.path().filename().string());
    }
    std::ranges::sort(ids);
    return ids;
}

nlohmann::json description_of(const std::string& id) {
    return nlohmann::json::parse(read_file(testing::source_dir() / "contestants" / id / "contestant.json"));
}

bool installed(const std::string& program) {
    return testing::run_shell("command -v " + program).status == 0;
}

bool in_ci() {
    const char* ci = std::getenv("CI");
    return ci != nullptr && std::string(ci) == "true";
}

const CellRecord& row_of(const Results& results, const std::string& method, const std::string& preset) {
    return *std::ranges::find_if(results.cells, [&](const CellRecord& cell) {
        return cell.method == method && cell.preset == preset;
    });
}

// A table may hold a method of ours beside the pass that it was written after.
TEST(ShippedContestants, HaveLabelsOfTheirOwn) {
    std::set<std::string> labels;
    const fs::path methods = testing::source_dir() / "shaders/methods";
    for (const auto& entry : fs::directory_iterator(methods))
        labels.insert(nlohmann::json::parse(read_file(entry.path() / "method.json")).at("label"));
    for (const std::string& id : shipped())
        EXPECT_TRUE(labels.insert(description_of(id).at("label")).second) << id;
}

/// Whether Blender found no OpenGL to draw with: Eevee needs a driver's, with or without a display.
bool has_no_opengl(const std::string& said) {
    return said.find("GLX or EGL context") != std::string::npos ||
           said.find("open a display") != std::string::npos;
}

class ShippedContestant : public ::testing::TestWithParam<std::string> {
  protected:
    void SetUp() override {
        const std::string program = description_of(GetParam()).at("command").at("words").at(0);
        const std::string needed = program == "node" ? "chromium" : program;
        if (installed(needed)) return;
        if (needed == "chromium" && in_ci()) FAIL() << needed << " is not installed";
        GTEST_SKIP() << needed << " is not installed";
    }

    const fs::path folder = output_dir();
};

// Its own depth, through the same importer and camera, is the G-buffer's.
TEST_P(ShippedContestant, SeesTheSurfacesThatTheViewShows) {
    nlohmann::json description = description_of(GetParam());
    nlohmann::json& command = description.at("command");
    nlohmann::json parameters = command.at("presets").at("default");
    const bool blender = command.at("words").at(0) == "blender";
    parameters["picture"] = "depth";
    if (blender) {
        description["channel"] = "ViewLayer.Depth.Z";
        parameters["samples"] = 1;
    }
    command["presets"] = {{"default", parameters}};
    command["version"] = "depth";
    fs::create_directories(folder / "contestants");
    fs::copy(testing::source_dir() / "contestants", folder / "contestants", fs::copy_options::recursive);
    write_atomically(folder / "contestants" / GetParam() / "contestant.json", description.dump());
    const auto drawn = run_aoscore("gbuffer " + std::string(kView) + " --out gbuffer.exr", folder);
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    // Depths are no visibility, but an image like any other; an infinite one would fail the row.
    const auto run = run_aoscore("score " + std::string(kView) +
                                     " --samples 2 --methods alchemy --contestant contestants/" + GetParam() +
                                     " --out page",
                                 folder);
    if (has_no_opengl(run.err)) GTEST_SKIP() << run.err;
    const Results results = read_results(folder / "page");
    const CellRecord& row = row_of(results, GetParam(), "default");
    ASSERT_FALSE(row.image_file.empty()) << row.error << "\n" << run.err;
    const ImageFile file = read_image(folder / "page" / row.image_file),
                    gbuffer = read_image(folder / "gbuffer.exr");
    const ImageF &theirs = *file.channel("Y"), &ours = *gbuffer.channel("Z"),
                 &mask = *gbuffer.channel("mask.Y");
    const auto differing = [&](int dx, int dy) {
        std::size_t count = 0;
        for (int y = 1; y + 1 < ours.height; ++y) {
            for (int x = 1; x + 1 < ours.width; ++x) {
                const double here = ours.at(x, y), there = theirs.at(x + dx, y + dy);
                const bool surface = mask.at(x, y) > 0.5F;
                // Far away there is no surface for either.
                count += surface ? !(std::abs(there / here - 1) < 5e-3) : there < results.views[0].far_m;
            }
        }
        return count;
    };
    // Edges may fall to either side; a shift by a pixel, a flip or another angle of view loses far more.
    const std::size_t unshifted = differing(0, 0);
    EXPECT_LT(unshifted, 0.05 * static_cast<double>(ours.size()));
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
        EXPECT_GT(differing(dx, dy), 2 * unshifted) << dx << ", " << dy;
}

/// The correlation of two pictures over the mask, the second mirrored where that is asked for.
double correlation(const ImageF& a, const ImageF& b, const ImageF& mask, bool mirrored) {
    double n = 0, sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const int other = mirrored ? a.width - 1 - x : x;
            if (mask.at(x, y) < 0.5F || mask.at(other, y) < 0.5F) continue;
            const double u = a.at(x, y), v = b.at(other, y);
            n += 1;
            sum_a += u;
            sum_b += v;
            aa += u * u;
            bb += v * v;
            ab += u * v;
        }
    }
    return (n * ab - sum_a * sum_b) / std::sqrt((n * aa - sum_a * sum_a) * (n * bb - sum_b * sum_b));
}

// Estimators differ in strength, so that no error tells a right one from a wrong one; where they are dark
// does.
TEST_P(ShippedContestant, IsDarkWhereTheTruthIs) {
    const auto run =
        run_aoscore("score pillar --view moved --size 160x90 --samples 64 --methods alchemy --contestant " +
                        GetParam() + " --out page",
                    folder);
    if (has_no_opengl(run.err)) GTEST_SKIP() << run.err;
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    const ImageFile truth = read_image(folder / "page" / results.views[0].truth_file);
    const ImageF &visibility = *truth.channel("V0.Y"), &mask = *truth.channel("mask.Y");
    const nlohmann::json presets = description_of(GetParam()).at("command").at("presets");
    for (const auto& [preset, values] : presets.items()) {
        const CellRecord& row = row_of(results, GetParam(), preset);
        ASSERT_EQ(row.error, "") << preset;
        const ImageFile file = read_image(folder / "page" / row.image_file);
        const double as_given = correlation(*file.channel("Y"), visibility, mask, false);
        EXPECT_GT(as_given, 0.4) << preset;
        EXPECT_GT(as_given, correlation(*file.channel("Y"), visibility, mask, true) + 0.2) << preset;
    }
}

// Another program's ray tracer, with its own scene, camera, sampling and random numbers: only the noise of
// its 64 samples is left, which is known to be unbiased.
TEST(Cycles, AboutTheNormalsOfTrianglesIsTheTruthUpToItsNoise) {
    if (!installed("blender")) GTEST_SKIP() << "blender is not installed";
    const fs::path folder = output_dir();
    for (const char* view : {"atrium --view wide", "pillar --view moved"}) {
        const auto run = run_aoscore("score " + std::string(view) +
                                         " --size 160x90 --samples 256 --methods alchemy --contestant "
                                         "blender-cycles --out page",
                                     folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Results results = read_results(folder / "page");
        const CellRecord &same = row_of(results, "blender-cycles", "triangle-normals"),
                         &few = row_of(results, "blender-cycles", "few-rays");
        EXPECT_LT(*same.ranked.at("rmse_debiased").value, 0.025) << view;
        EXPECT_LT(std::abs(*same.ranked.at("bias").value), 0.002) << view;
        // A sixteenth of the samples has four times the noise, or twice where their pattern is even.
        EXPECT_GT(*few.ranked.at("rmse_debiased").value, 2 * *same.ranked.at("rmse_debiased").value) << view;
    }
}

/// Blender's own file of a view, with all of its passes, and the camera file that it needs: blender.exr and
/// camera.json in the folder. Its world has z up: x, y, z there are x, -z, y of the request's scene.
void render_with_blender(const std::string& view, const fs::path& folder) {
    fs::create_directories(folder / "keeper");
    fs::copy(testing::source_dir() / "contestants/blender", folder / "blender");
    nlohmann::json description = description_of("blender-cycles");
    nlohmann::json& command = description.at("command");
    description["id"] = "keeper";
    command["words"] = {"sh", "{folder}/keep.sh", "{folder}/../blender/render.py", "{request}", "{output}"};
    command["files"] = {"keep.sh"};
    command["presets"] = {{"default", {{"samples", 64}, {"triangle_normals", true}}}};
    write_atomically(folder / "keeper/contestant.json", description.dump());
    write_atomically(folder / "keeper/keep.sh",
                     "blender --background --factory-startup --python-exit-code 1 --python \"$1\" -- cycles "
                     "\"$2\" && cp \"$3\" '" +
                         (folder / "blender.exr").string() + "' && cp \"$2\" '" +
                         (folder / "request.json").string() + "'");
    const auto run = run_aoscore(
        "score " + view + " --samples 2 --methods alchemy --contestant keeper --out kept", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const nlohmann::json camera = nlohmann::json::parse(read_file(folder / "request.json")).at("camera");
    const nlohmann::json& to_camera = camera.at("world_to_camera");
    nlohmann::json from_blender = nlohmann::json::array();
    for (std::size_t row = 0; row < 16; row += 4) {
        const double x = to_camera[row], y = to_camera[row + 1], z = to_camera[row + 2];
        for (const double number : {x, -z, y, to_camera[row + 3].get<double>()})
            from_blender.push_back(number);
    }
    write_atomically(folder / "camera.json", nlohmann::json({{"fovy_deg", camera.at("fovy_deg")},
                                                             {"near_m", camera.at("near_m")},
                                                             {"far_m", camera.at("far_m")},
                                                             {"normals", "world"},
                                                             {"world_to_camera", from_blender}})
                                                 .dump());
}

TEST(Blender, AFrameThatItWroteScoresMethodsAsItsSceneDoes) {
    if (!installed("blender")) GTEST_SKIP() << "blender is not installed";
    const fs::path folder = output_dir();
    const std::string view = "pillar --view moved --size 160x90", methods = " --methods gtao,hbao,alchemy";
    render_with_blender(view, folder);
    const auto frame = run_aoscore(
        "score --gbuffer blender.exr --camera camera.json --truth blender.exr "
        "--truth-channel ViewLayer.AO.R --radius 0.5 --out frame" +
            methods,
        folder);
    ASSERT_EQ(frame.exit_code, 0) << frame.err;
    const auto scene =
        run_aoscore("score " + view + " --samples 256 --radius 0.5 --out scene" + methods, folder);
    ASSERT_EQ(scene.exit_code, 0) << scene.err;
    const Results of_frame = read_results(folder / "frame"), of_scene = read_results(folder / "scene");
    EXPECT_THAT(of_frame.views.at(0).view_note, ::testing::HasSubstr("layout blender"));
    for (const CellRecord& cell : of_scene.cells) {
        const CellRecord& same = row_of(of_frame, cell.method, cell.preset);
        // The frame's truth is one of 64 samples, whose noise nobody knows.
        EXPECT_NEAR(*same.ranked.at("rmse").value, *cell.ranked.at("rmse").value, 0.01) << cell.method;
    }
}

/// What the program reads, by links, with only those npm packages that its own pages need.
fs::path installed_data(const fs::path& folder) {
    const fs::path data = folder / "data";
    fs::create_directories(data / "node_modules");
    for (const char* part : {"shaders", "scenes", "reports", "contestants"})
        fs::create_symlink(testing::source_dir() / part, data / part);
    for (const char* package : {"uplot", "sortable-tablesort"})
        fs::create_symlink(testing::source_dir() / "node_modules" / package, data / "node_modules" / package);
    return data;
}

// As the installed package does, it has the page's own packages alone.
TEST(ThreeJs, WithoutItsPackagesSaysWhatToInstallAndWhereAndFindsItThere) {
    const fs::path folder = output_dir(), user = folder / "home/.local/share/aoscore";
    const std::string as_installed = "env -u XDG_DATA_HOME HOME='" + (folder / "home").string() +
                                     "' AOSCORE_DATA='" + installed_data(folder).string() + "'";
    const auto row = [&] {
        run_aoscore(
            "score plane --view facing --size 32x18 --samples 4 --methods alchemy --contestant threejs-n8ao "
            "--out page",
            folder, as_installed);
        return row_of(read_results(folder / "page"), "threejs-n8ao", "default");
    };
    EXPECT_THAT(row().error, ::testing::AllOf(::testing::HasSubstr("the npm package n8ao is not installed"),
                                              ::testing::HasSubstr("npm install --prefix " + user.string() +
                                                                   " n8ao@2.1.0"),
                                              ::testing::HasSubstr("playwright-core@")));
    const fs::path modules = user / "node_modules";
    write_atomically(modules / "n8ao/package.json", R"({"version": "9.9.9"})");
    EXPECT_THAT(row().error, ::testing::HasSubstr("not installed in version 2.1.0, only in 9.9.9"));
    fs::remove_all(modules);
    fs::create_symlink(testing::source_dir() / "node_modules", modules);
    EXPECT_EQ(row().error, "");
}

INSTANTIATE_TEST_SUITE_P(Contestants, ShippedContestant, ::testing::ValuesIn(shipped()),
                         [](const auto& parameter) {
                             std::string name = parameter.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace aoscore
