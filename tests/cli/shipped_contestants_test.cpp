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
